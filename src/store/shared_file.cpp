#include "shared_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace idiophone::store {

hid_t SharedFile::opened() {
  if (!file.open()) {
    file = hdf5::open_file(path, communicator);
  }
  return file.id();
}

hdf5::Handle SharedFile::dataset(const std::string& name) {
  const auto id = opened();
  hdf5::Handle handle;
  parallel::collectively(communicator, [&] { handle = hdf5::open_dataset(id, name); });
  return handle;
}

bool SharedFile::close() {
  if (!file.open()) {
    return false;
  }
  const auto action = fmt::format("can't write {}", path.string());
  parallel::collectively(communicator, [&] { hdf5::check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), action); });
  parallel::collectively(communicator, [&] { file.close(action); });
  return true;
}

Lengths SharedFile::lengths() {
  const auto id = opened();
  Lengths lengths;
  parallel::collectively(communicator, [&] {
    for (const auto& name : hdf5::datasets_below(id, "/")) {
      if (const auto dataset = hdf5::open_dataset(id, name); hdf5::can_grow(dataset.id())) {
        lengths[name] = static_cast<std::int64_t>(hdf5::shape_of(dataset.id()).front());
      }
    }
  });
  return lengths;
}

void SharedFile::cut(const Lengths& lengths) {
  const auto present = this->lengths();
  parallel::collectively(communicator, [&] {
    for (const auto& [name, rows] : present) {
      const auto wanted = lengths.find(name);
      if (wanted == lengths.end() || wanted->second < 0 || wanted->second > rows) {
        throw std::runtime_error(fmt::format(
            "{} does not belong to the checkpoint: {} has {} rows, and had {} when the checkpoint was written; start "
            "the run anew",
            path.string(), name, rows, wanted == lengths.end() ? "none" : std::to_string(wanted->second)));
      }
    }
    for (const auto& [name, rows] : lengths) {
      if (!present.contains(name)) {
        throw std::runtime_error(
            fmt::format("{} does not belong to the checkpoint: it has no {}; start the run anew", path.string(), name));
      }
    }
  });
  for (const auto& [name, rows] : lengths) {
    const auto table = dataset(name);
    parallel::collectively(communicator, [&, rows = rows] { hdf5::set_rows(table.id(), static_cast<hsize_t>(rows)); });
  }
}

}  // namespace idiophone::store
