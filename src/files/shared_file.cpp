#include "idiophone/files/shared_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"

namespace idiophone::files {

namespace {

/// A use changes the metadata of a table, one or two kilobytes. So all stay far below the limit in hdf5.cpp.
constexpr int uses_between_flushes = 4000;

}  // namespace

hid_t SharedFile::opened() {
  if (!file.open()) {
    file = hdf5::open_file(path, communicator);
    uses = 0;
  }
  if (++uses == uses_between_flushes) {
    write_changes();
  }
  return file.id();
}

void SharedFile::write_changes() {
  const auto action = fmt::format("can't write {}", path.string());
  parallel::collectively(communicator, [&] { hdf5::check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), action); });
  uses = 0;
}

hdf5::Identifier SharedFile::dataset(const std::string& name) {
  const auto id = opened();
  hdf5::Identifier handle;
  parallel::collectively(communicator, [&] { handle = hdf5::open_dataset(id, name); });
  return handle;
}

bool SharedFile::close() {
  if (!file.open()) {
    return false;
  }
  write_changes();
  parallel::collectively(communicator, [&] { file.close(fmt::format("can't write {}", path.string())); });
  return true;
}

void SharedFile::add_checksums(const std::string& name, const hdf5::Identifier& table, std::int64_t first_row,
                               const std::vector<std::uint32_t>& rows) {
  const std::int64_t piece_rows = piece_rows_of(table.id());
  if (piece_rows == 0) {
    return;
  }
  std::vector<std::int64_t> pieces;
  parallel::on_root(communicator, [&] {
    const auto rest = static_cast<std::uint32_t>(hdf5::integer_of(table.id(), checksum_attribute));
    pieces = checksums_of_pieces(rest, first_row % piece_rows, rows, hdf5::bytes_of_row(table.id()), piece_rows);
  });
  parallel::broadcast(pieces, communicator);
  if (pieces.size() > 1) {
    const auto id = opened();
    hdf5::Identifier sums;
    parallel::collectively(communicator, [&] { sums = open_or_create_checksums(id, name); });
    auto box = hdf5::whole(sums.id());
    box.begin[0] = std::exchange(box.size[0], pieces.size() - 1);
    parallel::collectively(communicator, [&] { hdf5::set_rows(sums.id(), box.begin[0] + box.size[0]); });
    parallel::on_root(communicator, [&] {
      const std::span<const std::int64_t> full(pieces.data(), pieces.size() - 1);
      hdf5::reserve(file.id(), hdf5::growth(sums.id(), box.begin[0], box.size[0]));
      hdf5::write(sums.id(), box, full, hdf5::Transfer::alone);
    });
  }
  parallel::collectively(communicator, [&] { hdf5::replace(table.id(), checksum_attribute, pieces.back()); });
}

Lengths SharedFile::lengths() {
  const auto id = opened();
  Lengths lengths;
  parallel::collectively(communicator, [&] {
    for (const auto& name : hdf5::datasets_below(id, "/")) {
      const auto dataset = hdf5::open_dataset(id, name);
      if (hdf5::can_grow(dataset.id()) && !name.starts_with(checksums_group)) {
        lengths[name] = static_cast<std::int64_t>(hdf5::shape_of(dataset.id()).front());
      }
    }
  });
  return lengths;
}

void SharedFile::truncate(const Lengths& lengths) {
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
    cut_table(name, rows);
  }
}

void SharedFile::cut_table(const std::string& name, std::int64_t rows) {
  const auto id = opened();
  const auto table = dataset(name);
  parallel::collectively(communicator, [&] { hdf5::set_rows(table.id(), static_cast<hsize_t>(rows)); });
  const std::int64_t piece_rows = piece_rows_of(table.id());
  if (piece_rows == 0) {
    return;
  }
  std::int64_t rest = 0;
  parallel::on_root(communicator, [&] {
    const auto begin = static_cast<hsize_t>(rows - rows % piece_rows);
    rest = checksum_of_box(table.id(), hdf5::rows_of(table.id(), begin, static_cast<hsize_t>(rows) - begin));
  });
  parallel::broadcast(rest, communicator);
  parallel::collectively(communicator, [&] {
    cut_checksums(id, name, static_cast<hsize_t>(rows / piece_rows));
    hdf5::replace(table.id(), checksum_attribute, rest);
  });
}

void SharedFile::archive(parallel::Archive& archive, const std::string& prefix) {
  Lengths all = lengths();
  for (auto& [name, length] : all) {
    archive.root(fmt::format("{}/lengths{}", prefix, name), length);
  }
  if (archive.restoring()) {
    truncate(all);
  }
  for (const auto& entry : all) {
    const std::string& name = entry.first;
    const auto table = dataset(name);
    std::int64_t digest = 0;
    parallel::on_root(communicator, [&] { digest = digest_of(stored_checksums(file.id(), name, table.id())); });
    parallel::broadcast(digest, communicator);
    std::int64_t saved = digest;
    archive.root(fmt::format("{}/checksums{}", prefix, name), saved);
    parallel::agree(communicator, saved == digest ? "" : fmt::format("{}: {} is damaged", path.string(), name));
  }
}

}  // namespace idiophone::files
