#include "idiophone/foundation/web/page_file.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <fstream>
#include <stdexcept>

namespace idiophone::web {

void write_page(const std::string& path, const std::string& text) {
  if (!(std::ofstream(path) << text).flush()) {
    throw std::runtime_error(fmt::format("can't write {}", path));
  }
  spdlog::info("{}: {:.1f} MB; open it with a browser", path, static_cast<double>(text.size()) * 1e-6);
}

}  // namespace idiophone::web
