#include "idiophone/run/results/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/run/results/describe_file.hpp"

namespace idiophone::results {

namespace {

constexpr std::int64_t bytes_at_once = 1 << 20;

/// Reads all attributes; their values have HDF5's checksums.
void read_attributes(hid_t object) {
  for (const auto& name : hdf5::attribute_names(object)) {
    const hdf5::Identifier attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, name);
    const hdf5::Identifier type(H5Aget_type(attribute.id()), H5Tclose, name);
    const auto space = hdf5::space_of_attribute(attribute.id(), name);
    if (H5Tget_class(type.id()) == H5T_STRING) {
      static_cast<void>(hdf5::texts_of(object, name));
      continue;
    }
    std::vector<std::byte> bytes(hdf5::volume(hdf5::shape_of_space(space.id())) * H5Tget_size(type.id()) + 1);
    hdf5::check(H5Aread(attribute.id(), type.id(), bytes.data()), fmt::format("can't read attribute {}", name));
  }
}

/// Time of a row, s; none if the file does not contain it.
std::optional<double> time_of(hid_t file, const std::string& path, hid_t table, std::int64_t row) {
  if (hdf5::has(table, "rate")) {
    return static_cast<double>(row) / hdf5::number_of(table, "rate");
  }
  if (hdf5::has(file, "rate")) {  // a recording's
    const std::int64_t first = hdf5::has(file, "first_sample") ? hdf5::integer_of(file, "first_sample") : 0;
    return static_cast<double>(row + first) / hdf5::number_of(file, "rate");
  }
  if (path.starts_with("/frames/") && path != "/frames/time") {
    const auto times = hdf5::open_dataset(file, "/frames/time");
    return hdf5::read<double>(times.id(), hdf5::rows_of(times.id(), static_cast<hsize_t>(row), 1)).at(0);
  }
  return {};
}

class FileCheck {
 public:
  /// @param saved  compares the tables with these, up to their rows; null: with their own checksums
  explicit FileCheck(hid_t file, const SavedTables* saved) : file_(file), saved_(saved) {}

  Verification read() {
    const hdf5::Identifier root(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose, "can't open group /");
    visit(root.id(), "");
    for (const auto& [path, table] : saved_ != nullptr ? *saved_ : SavedTables()) {
      if (!tables_.contains(path)) {
        damaged(path, "it is missing");
      }
    }
    return std::move(result_);
  }

 private:
  void damaged(const std::string& path, const std::string& problem, std::optional<double> since = {}) {
    result_.damaged.push_back({path, problem, since});
  }

  /// @param path  of the group, without a slash at its end
  void visit(hid_t group, const std::string& path) {
    try {
      read_attributes(group);
      for (const auto& name : hdf5::names_in(group)) {
        visit_entry(group, name, fmt::format("{}/{}", path, name));
      }
    } catch (const std::exception& error) {  // a damaged size may be beyond any memory
      damaged(path.empty() ? "/" : path, error.what());
    }
  }

  void visit_entry(hid_t group, const std::string& name, const std::string& path) {
    try {
      const hdf5::Identifier object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, "can't be opened");
      hdf5::ObjectInfo info;  // with the sizes of its indices, so that these are read
      hdf5::check(H5Oget_info2(object.id(), &info, H5O_INFO_ALL), "its index can't be read");
      if (H5Iget_type(object.id()) == H5I_GROUP) {
        visit(object.id(), path);
      } else if (H5Iget_type(object.id()) == H5I_DATASET && !path.starts_with(files::checksums_group + "/")) {
        read_attributes(object.id());
        read_dataset(object.id(), path);
      }
    } catch (const std::exception& error) {
      damaged(path, error.what());
    }
  }

  void read_dataset(hid_t dataset, const std::string& path) {
    static_cast<void>(hdf5::stored_volume(dataset, hdf5::whole(dataset)));
    const std::int64_t piece_rows = files::piece_rows_of(dataset);
    if (piece_rows > 0) {
      read_table(dataset, path, piece_rows);
      return;
    }
    const auto shape = hdf5::shape_of(dataset);
    const auto row_bytes = static_cast<std::int64_t>(shape.empty() ? 0 : hdf5::bytes_of_row(dataset));
    std::uint32_t sum = 0;
    if (row_bytes > 0) {
      const hdf5::Identifier type(H5Dget_type(dataset), H5Tclose, path);
      const bool of_fixed_size = H5Tis_variable_str(type.id()) == 0;
      sum = of_fixed_size ? checksum_by_pieces(dataset, std::max<std::int64_t>(bytes_at_once / row_bytes, 1)) : 0;
    }
    if (!hdf5::has(dataset, files::checksum_attribute)) {
      if (saved_ != nullptr) {
        damaged(path, "it has no checksum; all that a run writes has one");
      }
      ++result_.unproved;
    } else if (hdf5::integer_of(dataset, files::checksum_attribute) == sum) {
      ++result_.intact;
    } else {
      damaged(path, "its values do not match their checksum");
    }
  }

  static std::uint32_t checksum_by_pieces(hid_t dataset, std::int64_t piece_rows) {
    const auto rows = static_cast<std::int64_t>(hdf5::row_count(dataset));
    std::uint32_t sum = 0;
    for (std::int64_t row = 0; row < rows; row += piece_rows) {
      const auto count = static_cast<hsize_t>(std::min(piece_rows, rows - row));
      sum = files::checksum_of_box(dataset, hdf5::rows_of(dataset, static_cast<hsize_t>(row), count), sum);
    }
    return sum;
  }

  void read_table(hid_t table, const std::string& path, std::int64_t piece_rows) {
    tables_.insert(path);
    auto rows = static_cast<std::int64_t>(hdf5::row_count(table));
    const auto stored = files::stored_checksums(file_, path, table);
    std::optional<std::int64_t> digest;
    const std::int64_t all_rows = rows;
    if (saved_ != nullptr) {
      const auto saved = saved_->find(path);
      if (saved == saved_->end()) {
        return;  // SharedFile::truncate() reports it
      }
      if (saved->second.rows > rows) {
        damaged(path, fmt::format("it has {} rows, but had {} at the checkpoint", rows, saved->second.rows));
        return;
      }
      digest = saved->second.digest;
      rows = saved->second.rows;
    }
    compare(table, path, piece_rows, files::computed_checksums(table, rows, piece_rows), stored, digest);
    if (!files::can_read_rows(table, rows, all_rows, piece_rows)) {  // then they can't be cut away
      damaged(path, fmt::format("its rows from row {} on can't be read", rows), time_of(file_, path, table, rows));
    }
  }

  /// @param computed  [pieces] of the rows to be compared
  /// @param stored    of all rows
  /// @param digest    expected one of the checksums; none: the last checksum is compared, too
  void compare(hid_t table, const std::string& path, std::int64_t piece_rows, const std::vector<std::int64_t>& computed,
               const std::vector<std::int64_t>& stored, const std::optional<std::int64_t>& digest) {
    const auto full = static_cast<std::ptrdiff_t>(computed.size()) - 1;
    const auto compared = full + (digest ? 0 : 1);
    std::ptrdiff_t wrong = 0, first = compared;
    for (std::ptrdiff_t piece = compared; piece-- > 0;) {
      if (piece >= static_cast<std::ptrdiff_t>(stored.size()) || computed[piece] != stored[piece]) {
        ++wrong;
        first = piece;
      }
    }
    if (digest && wrong == 0 && files::digest_of(computed) != *digest) {
      wrong = 1;
      first = full;
    }
    if (wrong == 0) {
      ++result_.intact;
      return;
    }
    const std::int64_t row = first * piece_rows;
    damaged(path,
            fmt::format("{} of {} pieces of {} rows do not match their checksums, the first from row {} on", wrong,
                        computed.size(), piece_rows, row),
            time_of(file_, path, table, row));
  }

  hid_t file_;
  const SavedTables* saved_;
  std::set<std::string> tables_;  ///< that were found
  Verification result_;
};

[[noreturn]] void refuse(const std::filesystem::path& path, const Damage& damage) {
  const auto since = damage.since ? fmt::format(" from {:.6g} s on", *damage.since) : "";
  throw std::runtime_error(fmt::format("{} is damaged: {}{}: {}; idiophone info --verify lists all", path.string(),
                                       damage.path, since, damage.problem));
}

}  // namespace

Verification verify(const std::filesystem::path& path) {
  return files::read_within_limit(path, [&] {
    const auto file = open_described(path);
    auto result = FileCheck(file.id(), nullptr).read();
    if (result.damaged.empty() && files::format_of(file.id()) == files::checkpoint_format) {
      if (const auto reason = damage(path); !reason.empty()) {
        result.damaged.push_back({"/", reason, {}});
      }
    }
    return result;
  });
}

void require_intact(const std::filesystem::path& path) {
  if (const auto result = verify(path); !result.damaged.empty()) {
    refuse(path, result.damaged.front());
  }
}

void require_as_saved(const std::filesystem::path& path, const SavedTables& tables) {
  const auto result =
      files::read_within_limit(path, [&] { return FileCheck(open_described(path).id(), &tables).read(); });
  if (!result.damaged.empty()) {
    refuse(path, result.damaged.front());
  }
}

}  // namespace idiophone::results
