#include "rebuild.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading_limit.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/run/results/describe_file.hpp"

namespace idiophone::results {

namespace {

/// Copies an attribute of any type.
void copy_attribute(hid_t from, hid_t to, const std::string& name) {
  const hdf5::Identifier source(H5Aopen(from, name.c_str(), H5P_DEFAULT), H5Aclose, name);
  const hdf5::Identifier type(H5Aget_type(source.id()), H5Tclose, name);
  const auto space = hdf5::space_of_attribute(source.id(), name);
  std::vector<std::byte> value(std::max<hsize_t>(H5Aget_storage_size(source.id()), 1));
  const hdf5::Identifier copy(H5Acreate2(to, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                              name);
  hdf5::check(H5Aread(source.id(), type.id(), value.data()), name);
  const herr_t written = H5Awrite(copy.id(), type.id(), value.data());
  hdf5::check(H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, value.data()), name);
  hdf5::check(written, name);
}

void copy_attributes(hid_t from, hid_t to) {
  for (const std::string& name : hdf5::attribute_names(from)) {
    copy_attribute(from, to, name);
  }
}

class Copy {
 public:
  Copy(hid_t source, hid_t target, const SavedTables& tables) : source_(source), target_(target), tables_(tables) {}

  /// @param path  of a group, without a slash at its end
  void copy_group(const std::string& path) {
    const std::string name = path.empty() ? "/" : path;
    const hdf5::Identifier from(H5Gopen2(source_, name.c_str(), H5P_DEFAULT), H5Gclose, "can't open group " + name);
    const hdf5::Identifier to = hdf5::open_group(target_, name);
    copy_attributes(from.id(), to.id());
    for (const hdf5::Entry& entry : hdf5::entries_of(from.id())) {
      const std::string inside = path + "/" + entry.name;
      if (inside == files::checksums_group) {
        continue;  // its tables come with theirs
      }
      if (entry.is_group) {
        copy_group(inside);
      } else {
        copy_dataset(inside);
      }
    }
  }

 private:
  void copy_dataset(const std::string& path) {
    const hdf5::Identifier dataset = hdf5::open_dataset(source_, path);
    if (const auto saved = tables_.find(path); saved != tables_.end()) {
      copy_table(path, dataset.id(), saved->second.rows);
    } else {
      hdf5::check(H5Ocopy(source_, path.c_str(), target_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                  fmt::format("can't copy {}", path));
    }
  }

  void copy_table(const std::string& path, hid_t from, std::int64_t rows) {
    const std::int64_t piece_rows = files::piece_rows_of(from);
    const hdf5::Identifier type(H5Dget_type(from), H5Tclose, path);
    const hdf5::Dimensions shape = hdf5::shape_of(from);
    if (piece_rows == 0 || rows < 0 || static_cast<hsize_t>(rows) > shape.at(0)) {
      throw std::runtime_error(fmt::format("{} does not have the rows of the checkpoint", path));
    }
    const auto to = files::create_checked_table(target_, path, type.id(), {shape.begin() + 1, shape.end()},
                                                static_cast<hsize_t>(piece_rows));
    for (const std::string& name : hdf5::attribute_names(from)) {
      if (!hdf5::has(to.id(), name)) {
        copy_attribute(from, to.id(), name);
      }
    }
    hdf5::set_rows(to.id(), static_cast<hsize_t>(rows));
    std::vector<std::byte> values(static_cast<std::size_t>(piece_rows) * hdf5::bytes_of_row(from));
    for (std::int64_t row = 0; row < rows; row += piece_rows) {
      const auto count = static_cast<hsize_t>(std::min(piece_rows, rows - row));
      const hdf5::Hyperslab box = hdf5::rows_of(from, static_cast<hsize_t>(row), count);
      hdf5::read_bytes(from, box, type.id(), values.data());
      hdf5::write_bytes(to.id(), box, type.id(), values.data(), hdf5::Transfer::alone);
    }
    put_computed_checksums(path, to.id(), rows, piece_rows);
  }

  void put_computed_checksums(const std::string& path, hid_t table, std::int64_t rows, std::int64_t piece_rows) const {
    const auto sums = files::computed_checksums(table, rows, piece_rows);
    hdf5::replace(table, files::checksum_attribute, sums.back());
    if (sums.size() > 1) {
      const auto full = files::open_or_create_checksums(target_, path);
      hdf5::set_rows(full.id(), sums.size() - 1);
      hdf5::write(full.id(), hdf5::whole(full.id()), std::span(sums).first(sums.size() - 1), hdf5::Transfer::alone);
    }
  }

  hid_t source_, target_;
  const SavedTables& tables_;
};

}  // namespace

void rebuild_as_saved(const std::filesystem::path& path, const SavedTables& tables) {
  auto part = path;
  part += ".part";
  try {
    const files::ReadingLimit limit(path);
    const hdf5::Identifier source = open_described(path);
    hdf5::Identifier target = hdf5::create_file(part, MPI_COMM_SELF);
    Copy(source.id(), target.id(), tables).copy_group("");
    target.close(fmt::format("can't write {}", part.string()));
    require_as_saved(part, tables);
    files::synchronise(part);
    files::rename_durably(part, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

}  // namespace idiophone::results
