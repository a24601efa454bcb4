#include "format.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "attributes.hpp"

namespace idiophone::store {

std::string format_of(hid_t file) {
  return hdf5::has(file, "format") ? hdf5::text_of(file, "format") : "";
}

void check_format(hid_t file, const std::string& format, const std::filesystem::path& path) {
  if (const auto found = format_of(file); found != format) {
    throw std::runtime_error(fmt::format("{} is not an {} but {}", path.string(), format,
                                         found.empty() ? "another program's file" : fmt::format("an {}", found)));
  }
  if (const auto version = hdf5::integer_of(file, "format_version"); version != format_version) {
    throw std::runtime_error(fmt::format("{} has version {} of the format '{}'; this program knows version {}",
                                         path.string(), version, format, format_version));
  }
}

}  // namespace idiophone::store
