#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/atomic_file.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/tables.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/run/results/checkpoint.hpp"
#include "idiophone/run/results/checkpoint_format.hpp"

namespace idiophone::results {

struct CheckpointWriter::State {
  std::filesystem::path directory, part;
  Identity identity;
  Moment moment;
  MPI_Comm communicator = MPI_COMM_NULL;
  hdf5::Identifier file;
  Checksums checksums;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  State(State&&) = delete;
  State& operator=(State&&) = delete;
  /// Removes an incomplete file.
  ~State() {
    file = {};
    std::error_code ignored;  // the next writing removes it if this can't
    if (parallel::rank_of(communicator) == 0 && !part.empty()) {
      std::filesystem::remove(part, ignored);
    }
  }
};

namespace {

std::string path_of(const std::string& name) {
  return "/state/" + name;
}

void prepare(const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const auto& path = entry.path();
    if (path.extension() == ".part" && (step_of(path.stem()) || path.stem() == "latest")) {
      std::filesystem::remove(path);
    }
  }
}

void remove_all_but(int keep, const std::filesystem::path& newest) {
  int kept = 0;
  for (const auto& path : list_checkpoints(newest.parent_path())) {
    const bool replaced = step_of(path) > step_of(newest);
    if (replaced || ++kept > keep) {
      std::filesystem::remove(path);
    }
  }
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::filesystem::path& directory, const Identity& identity,
                                   const Moment& moment, MPI_Comm communicator)
    : state_(std::make_unique<State>()) {
  auto& state = *state_;
  state.communicator = communicator;
  state.directory = directory;
  state.moment = moment;
  state.identity = {.code_version = parallel::from_root(identity.code_version, communicator),
                    .mesh_hash = parallel::from_root(identity.mesh_hash, communicator),
                    .deck_text = parallel::from_root(identity.deck_text, communicator),
                    .overrides = parallel::from_root(identity.overrides, communicator)};
  parallel::on_root(communicator, [&] { prepare(directory); });
  state.part = directory / (checkpoint_name(moment.step) + ".part");
  state.file = hdf5::create_file(state.part, communicator);
  parallel::collectively(communicator, [&] { write_header(state.file.id(), state.identity, moment, communicator); });
}

CheckpointWriter::CheckpointWriter(CheckpointWriter&&) noexcept = default;
CheckpointWriter& CheckpointWriter::operator=(CheckpointWriter&&) noexcept = default;
CheckpointWriter::~CheckpointWriter() = default;

template <class T>
void CheckpointWriter::write_root_and_sum(const std::string& name, std::span<const T> values) {
  state_->checksums[path_of(name)] =
      files::write_from_rank_0(state_->file.id(), path_of(name), values, state_->communicator);
}

void CheckpointWriter::add_rows(const std::string& name, const parallel::Rows& rows, int width,
                                std::span<const double> values) {
  state_->checksums[path_of(name)] = files::write_rows(state_->file.id(), path_of(name), rows, width, values);
}

void CheckpointWriter::add_root(const std::string& name, std::span<const double> values) {
  write_root_and_sum(name, values);
}

void CheckpointWriter::add_root(const std::string& name, std::span<const std::int64_t> values) {
  write_root_and_sum(name, values);
}

std::filesystem::path CheckpointWriter::commit(int keep) {
  auto& state = *state_;
  const auto action = fmt::format("can't write {}", state.part.string());
  const auto file = state.file.id();
  // All data must be on the disk before the end marker.
  parallel::collectively(state.communicator, [&] { hdf5::check(H5Fflush(file, H5F_SCOPE_GLOBAL), action); });
  parallel::collectively(state.communicator, [&] {
    hdf5::put(file, "end_marker", static_cast<std::int64_t>(end_marker(state.identity, state.moment, state.checksums)));
  });
  parallel::collectively(state.communicator, [&] { hdf5::check(H5Fflush(file, H5F_SCOPE_GLOBAL), action); });
  parallel::collectively(state.communicator, [&] { state.file.close(action); });

  auto path = state.directory / checkpoint_name(state.moment.step);
  parallel::on_root(state.communicator, [&] {
    files::synchronise(state.part);
    files::rename_durably(state.part, path);
    files::write_atomically(state.directory / "latest", path.filename().string() + "\n");
    remove_all_but(keep, path);
  });
  return path;
}

}  // namespace idiophone::results
