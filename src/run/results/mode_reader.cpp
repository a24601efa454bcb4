#include "idiophone/run/results/mode_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"

namespace idiophone::results {

namespace {

std::vector<double> whole_dataset(hid_t file, const std::string& path) {
  const auto dataset = hdf5::open_dataset(file, path);
  return hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()));
}

/// @throws std::runtime_error where the numbers contradict each other
StoredModes read_body_modes(hid_t file, const std::string& body) {
  const auto path = [&](const std::string& name) { return fmt::format("/modes/{}/{}", body, name); };
  StoredModes modes{.body = body,
                    .frequencies = whole_dataset(file, path("frequency")),
                    .decay_times = whole_dataset(file, path("decay_time")),
                    .mesh_errors = hdf5::exists(file, path("mesh_error")) ? whole_dataset(file, path("mesh_error"))
                                                                          : std::vector<double>(),
                    .kinds = {},
                    .shapes = {}};
  if (hdf5::exists(file, path("kind"))) {
    modes.kinds = hdf5::texts_in(file, path("kind"));
  }
  const hdf5::Dimensions shape = hdf5::shape_of(hdf5::open_dataset(file, path("shape")).id());
  const hdf5::Dimensions nodes = hdf5::shape_of(hdf5::open_dataset(file, fmt::format("/mesh/{}/nodes", body)).id());
  if (shape.size() != 3 || shape[0] != modes.frequencies.size() || nodes.empty() || shape[1] != nodes[0] ||
      shape[2] != 3 || modes.decay_times.size() != shape[0] || (modes.kinds && modes.kinds->size() != shape[0]) ||
      (!modes.mesh_errors.empty() && modes.mesh_errors.size() != shape[0])) {
    throw std::runtime_error(fmt::format("the modes and the mesh of body {} contradict each other", body));
  }
  const std::vector<double> all = whole_dataset(file, path("shape"));
  const auto width = static_cast<std::ptrdiff_t>(3 * shape[1]);
  for (auto at = all.begin(); at != all.end() && width > 0; at += width) {
    modes.shapes.emplace_back(at, at + width);
  }
  return modes;
}

}  // namespace

std::vector<StoredModes> read_modes(const std::filesystem::path& modes) {
  return files::read_within_limit(modes, [&] {
    const auto file = hdf5::open_for_reading(modes);
    files::check_format(file.id(), files::result_format, modes);
    const std::string prefix = "/modes/";
    const std::string suffix = "/frequency";
    std::vector<StoredModes> all;
    for (const auto& path : hdf5::datasets_below(file.id(), "/modes")) {
      if (path.ends_with(suffix)) {
        all.push_back(
            read_body_modes(file.id(), path.substr(prefix.size(), path.size() - prefix.size() - suffix.size())));
      }
    }
    return all;
  });
}

}  // namespace idiophone::results
