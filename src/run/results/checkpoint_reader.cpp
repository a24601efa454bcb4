#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/tables.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/run/results/checkpoint.hpp"
#include "idiophone/run/results/checkpoint_format.hpp"
#include "idiophone/run/results/verification.hpp"
#include "rebuild.hpp"

namespace idiophone::results {

// Every rank opens the file independently: then nothing is collective in HDF5, and a damaged file can't make ranks
// hang.
struct CheckpointReader::State {
  std::filesystem::path path;
  MPI_Comm communicator = MPI_COMM_NULL;
  hdf5::Identifier file;
  Identity identity;
  Moment moment;
};

namespace {

/// The share of a dataset's rows that this rank reads.
hdf5::Hyperslab own_rows(hid_t dataset, MPI_Comm communicator) {
  auto box = hdf5::whole(dataset);
  const auto rank = static_cast<hsize_t>(parallel::rank_of(communicator)),
             ranks = static_cast<hsize_t>(parallel::size_of(communicator));
  const auto rows = hdf5::row_count(dataset);
  box.begin[0] = rows * rank / ranks;
  box.size[0] = rows * (rank + 1) / ranks - box.begin[0];
  return box;
}

/// The bytes of this rank's share of a dataset.
std::vector<std::byte> own_bytes(hid_t dataset, MPI_Comm communicator) {
  const auto box = own_rows(dataset, communicator);
  const hdf5::Identifier type(H5Dget_type(dataset), H5Tclose, "HDF5 type");
  std::vector<std::byte> bytes(hdf5::stored_volume(dataset, box) * H5Tget_size(type.id()));
  hdf5::read_bytes(dataset, box, type.id(), bytes.data());
  return bytes;
}

/// Reads all data once and compares the checksums. Collective.
Checksums verify_checksums(hid_t file, MPI_Comm communicator) {
  std::vector<std::string> paths;
  parallel::collectively(communicator, [&] { paths = hdf5::datasets_below(file, "/state"); });
  Checksums checksums;
  for (const auto& path : paths) {
    hdf5::Identifier dataset;
    std::vector<std::byte> bytes;
    std::int64_t expected = 0;
    parallel::collectively(communicator, [&] {
      dataset = hdf5::open_dataset(file, path);
      expected = hdf5::integer_of(dataset.id(), "crc32");
      bytes = own_bytes(dataset.id(), communicator);
    });
    checksums[path] = files::checksum_of_blocks(bytes, communicator);
    parallel::agree(communicator, checksums[path] == expected ? "" : fmt::format("bad checksum of {}", path));
  }
  return checksums;
}

void check_complete(hid_t file) {
  if (!hdf5::has(file, "end_marker")) {
    throw std::runtime_error("no end marker: it is incomplete");
  }
}

/// Opens a table of the given shape and type.
hdf5::Identifier open_table(hid_t file, const std::string& name, const hdf5::Dimensions& shape, hid_t type) {
  const auto path = "/state/" + name;
  auto dataset = hdf5::open_dataset(file, path);
  const hdf5::Identifier stored(H5Dget_type(dataset.id()), H5Tclose, path);
  if (H5Tequal(stored.id(), type) <= 0) {
    throw std::runtime_error(fmt::format("{} holds values of another type", path));
  }
  if (const auto found = hdf5::shape_of(dataset.id()); !shape.empty() && found != shape) {
    throw std::runtime_error(fmt::format("{} does not have {} rows of {}", path, shape[0], shape[1]));
  }
  return dataset;
}

template <class T>
std::vector<T> read_whole(hid_t file, const std::string& name, MPI_Comm communicator) {
  std::vector<T> values;
  parallel::collectively(communicator, [&] {
    const auto dataset = open_table(file, name, {}, hdf5::type_of<T>());
    values = hdf5::read<T>(dataset.id(), hdf5::whole(dataset.id()));
  });
  return values;
}

std::string in_words(const std::vector<std::string>& overrides) {
  return overrides.empty() ? "no --set" : fmt::format("--set '{}'", fmt::join(overrides, "' --set '"));
}

/// Why a valid checkpoint belongs to another run; empty if it does not.
std::string difference(const Identity& found, const Identity& wanted) {
  if (found.code_version != wanted.code_version) {
    return fmt::format("other code version: {} wrote it, this is {}", found.code_version, wanted.code_version);
  }
  if (found.mesh_hash != wanted.mesh_hash) {
    return fmt::format("other mesh: its hash is {}, that of this run is {}", found.mesh_hash, wanted.mesh_hash);
  }
  if (found.deck_text != wanted.deck_text) {
    return "other deck: the text of the deck or of the sonic scene has changed since it was written";
  }
  return found.overrides == wanted.overrides
             ? ""
             : fmt::format("other overrides: it was written by a run with {}, this one has {}",
                           in_words(found.overrides), in_words(wanted.overrides));
}

/// A checkpoint's state of the tables of a file that is continued.
SavedTables saved_tables(hid_t checkpoint, const std::string& prefix) {
  const auto number = [&](const std::string& path) {
    const auto dataset = hdf5::open_dataset(checkpoint, path);
    const auto values = hdf5::read<std::int64_t>(dataset.id(), hdf5::whole(dataset.id()));
    if (values.size() != 1) {
      throw std::runtime_error(fmt::format("{} is not one number", path));
    }
    return values[0];
  };
  const std::string lengths = "/state/" + prefix + "/lengths", checksums = "/state/" + prefix + "/checksums";
  SavedTables tables;
  for (const auto& path : hdf5::datasets_below(checkpoint, lengths)) {
    const auto name = path.substr(lengths.size());
    tables[name] = {number(path), number(checksums + name)};
  }
  return tables;
}

/// Makes a file one that can be continued: one that is damaged after the checkpoint is rebuilt.
/// @return whether it was
/// @throws std::runtime_error if it is damaged before the checkpoint
bool make_as_saved(const std::filesystem::path& path, const SavedTables& tables) {
  try {
    require_as_saved(path, tables);
    return false;
  } catch (const std::runtime_error& damage) {
    try {
      rebuild_as_saved(path, tables);
      return true;
    } catch (const std::runtime_error&) {
      throw damage;
    }
  }
}

/// Why the files can't be continued from a checkpoint; empty if they can. Collective: rank 0 reads.
/// @param rebuilt  takes the files that were rebuilt
std::string compare_files(const std::vector<ContinuedFile>& files, const std::filesystem::path& checkpoint,
                          std::vector<std::string>& rebuilt, MPI_Comm communicator) {
  std::string problem;
  parallel::on_root(communicator, [&] {
    try {
      const auto file = hdf5::open_for_reading(checkpoint);
      for (const auto& [path, prefix] : files) {
        if (make_as_saved(path, saved_tables(file.id(), prefix))) {
          rebuilt.push_back(path.string());
        }
      }
    } catch (const std::runtime_error& error) {
      problem = error.what();
    }
  });
  parallel::broadcast(rebuilt, communicator);
  return parallel::from_root(problem, communicator);
}

/// Checkpoints in the order of the attempts.
std::vector<std::string> candidates(const std::filesystem::path& directory) {
  std::vector<std::string> paths;
  std::string name;
  if (std::ifstream pointer(directory / "latest"); std::getline(pointer, name) && step_of(name)) {
    paths.push_back(directory / std::filesystem::path(name).filename());
  }
  for (const auto& path : list_checkpoints(directory)) {
    if (std::ranges::find(paths, path.string()) == paths.end()) {
      paths.push_back(path);
    }
  }
  return paths;
}

}  // namespace

CheckpointReader::CheckpointReader(const std::filesystem::path& path, MPI_Comm communicator)
    : state_(std::make_unique<State>()) {
  state_->path = path;
  state_->communicator = communicator;
  auto& file = state_->file;
  std::int64_t marker = 0;
  parallel::collectively(communicator, [&] {
    file = hdf5::open_for_reading(path);
    files::check_format(file.id(), files::checkpoint_format, path);
    check_complete(file.id());
    state_->identity = read_identity(file.id());
    state_->moment = read_moment(file.id());
    marker = hdf5::integer_of(file.id(), "end_marker");
  });
  const auto checksums = verify_checksums(file.id(), communicator);
  parallel::agree(communicator, marker == end_marker(state_->identity, state_->moment, checksums)
                                    ? ""
                                    : "the end marker does not match the contents");
}

CheckpointReader::CheckpointReader(CheckpointReader&&) noexcept = default;
CheckpointReader& CheckpointReader::operator=(CheckpointReader&&) noexcept = default;
CheckpointReader::~CheckpointReader() = default;

const std::filesystem::path& CheckpointReader::path() const {
  return state_->path;
}

const Identity& CheckpointReader::identity() const {
  return state_->identity;
}

const Moment& CheckpointReader::moment() const {
  return state_->moment;
}

std::vector<double> CheckpointReader::read_rows(const std::string& name, const parallel::Rows& rows, int width) const {
  std::vector<double> block;
  parallel::collectively(rows.communicator(), [&] {
    const auto dataset =
        open_table(state_->file.id(), name, {static_cast<hsize_t>(rows.global_rows()), static_cast<hsize_t>(width)},
                   hdf5::type_of<double>());
    block = hdf5::read<double>(dataset.id(), files::block_of(rows, width));
  });
  return rows.from_blocks(std::span<const double>(block), width);
}

std::vector<double> CheckpointReader::read_root(const std::string& name) const {
  return read_whole<double>(state_->file.id(), name, state_->communicator);
}

std::vector<std::int64_t> CheckpointReader::read_integer_root(const std::string& name) const {
  return read_whole<std::int64_t>(state_->file.id(), name, state_->communicator);
}

CheckpointSearch find_checkpoint(const std::filesystem::path& directory, const Identity& identity,
                                 const std::vector<ContinuedFile>& files, MPI_Comm communicator) {
  const Identity wanted{.code_version = parallel::from_root(identity.code_version, communicator),
                        .mesh_hash = parallel::from_root(identity.mesh_hash, communicator),
                        .deck_text = parallel::from_root(identity.deck_text, communicator),
                        .overrides = parallel::from_root(identity.overrides, communicator)};
  std::vector<std::string> paths;
  parallel::on_root(communicator, [&] { paths = candidates(directory); });
  CheckpointSearch search;
  for (const auto& path : parallel::from_root(paths, communicator)) {
    try {
      CheckpointReader reader(path, communicator);
      auto reason = difference(reader.identity(), wanted);
      if (reason.empty()) {
        reason = compare_files(files, path, search.rebuilt, communicator);
      }
      if (reason.empty()) {
        search.checkpoint = std::move(reader);
        return search;
      }
      search.refused.push_back({path, reason});
    } catch (const std::runtime_error& error) {  // the same on all ranks, by parallel::collectively()
      search.refused.push_back({path, error.what()});
    }
  }
  return search;
}

}  // namespace idiophone::results
