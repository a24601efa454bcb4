#include "idiophone/files/format.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::files {

std::string format_of(hid_t file) {
  return hdf5::has(file, "format") ? hdf5::text_of(file, "format") : "";
}

void check_format(hid_t file, const std::string& format, const std::filesystem::path& path) {
  if (const auto found = format_of(file); found != format) {
    throw std::runtime_error(fmt::format("{} is not an {} but {}", path.string(), format,
                                         found.empty() ? "another program's file" : fmt::format("an {}", found)));
  }
  if (const auto version = hdf5::integer_of(file, "format_version"); version != version_of(format)) {
    throw std::runtime_error(fmt::format("{} has version {} of the format '{}'; this program knows version {}",
                                         path.string(), version, format, version_of(format)));
  }
}

void write_origin(hid_t file, const std::string& format, const Origin& origin, MPI_Comm communicator) {
  const auto name = parallel::from_root(origin.name, communicator);
  const auto code_version = parallel::from_root(origin.code_version, communicator);
  const auto deck_text = parallel::from_root(origin.deck_text, communicator);
  const auto overrides = parallel::from_root(origin.overrides, communicator);
  parallel::collectively(communicator, [&] {
    hdf5::put(file, "format", format);
    hdf5::put(file, "format_version", version_of(format));
    hdf5::put(file, "code_version", code_version);
    hdf5::put(file, "name", name);
  });
  parallel::collectively(communicator, [&] { hdf5::put_dataset(file, "/deck", {deck_text}, communicator); });
  parallel::collectively(communicator, [&] { hdf5::put_dataset(file, "/overrides", overrides, communicator); });
}

}  // namespace idiophone::files
