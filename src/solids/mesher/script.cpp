#include "script.hpp"

#include <fmt/format.h>
#include <gmsh.h>
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

namespace idiophone::mesher {

Script::Script(const std::string& text) : file_(memfd_create("script.geo", MFD_CLOEXEC)) {
  if (file_ < 0 || write(file_, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    throw std::runtime_error("there is no memory for the parameters");
  }
}

Script::~Script() {
  close(file_);
}

void Script::run() const {
  gmsh::open(fmt::format("/proc/self/fd/{}", file_));
}

}  // namespace idiophone::mesher
