// The part of a result that `idiophone modes` writes.

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/tables.hpp"
#include "result_state.hpp"

namespace idiophone::results {

namespace {

void check_counts(const BodyModes& modes) {
  const std::size_t count = modes.frequencies.size();
  if (count == 0 || modes.damping_ratios.size() != count || modes.decay_times.size() != count ||
      modes.shapes.size() != count || modes.kinetic_shares.size() != count || modes.kinds.size() != count ||
      (!modes.mesh_errors.empty() && modes.mesh_errors.size() != count)) {
    throw std::runtime_error(
        fmt::format("modes of body {}: {} frequencies, {} damping ratios, {} decay times, {} "
                    "errors, {} shares of kinetic energy, {} kinds and {} shapes",
                    modes.body, count, modes.damping_ratios.size(), modes.decay_times.size(), modes.mesh_errors.size(),
                    modes.kinetic_shares.size(), modes.kinds.size(), modes.shapes.size()));
  }
}

/// Writes the shapes mode by mode: only one is rearranged into blocks of rows at a time.
void write_shapes(hid_t file, const std::string& path, const BodyModes& modes) {
  const parallel::Rows& nodes = *modes.nodes;
  MPI_Comm communicator = nodes.communicator();
  const auto count = static_cast<hsize_t>(modes.shapes.size());
  hdf5::Identifier dataset;
  parallel::collectively(communicator, [&] {
    dataset =
        hdf5::create_dataset(file, path, H5T_NATIVE_DOUBLE, {count, static_cast<hsize_t>(nodes.global_rows()), 3});
    hdf5::put(dataset.id(), "unit", std::string("m"));
  });
  parallel::on_root(communicator,
                    [&] { hdf5::reserve(file, hdf5::volume(hdf5::shape_of(dataset.id())) * sizeof(double)); });
  const auto rows = files::block_of(nodes, 3);
  std::uint32_t sum = 0;
  for (hsize_t mode = 0; mode < count; ++mode) {
    const auto block = nodes.to_blocks(modes.shapes[mode], 3);
    const hdf5::Hyperslab box{.begin = {mode, rows.begin[0], 0}, .size = {1, rows.size[0], 3}};
    parallel::collectively(communicator, [&] {
      hdf5::write(dataset.id(), box, std::span<const double>(block), hdf5::Transfer::together);
    });
    sum = files::checksum_of_blocks(std::as_bytes(std::span(block)), communicator, sum);
  }
  files::put_checksum(dataset, sum, communicator);
}

}  // namespace

void ResultFile::add_modes(const BodyModes& modes) {
  MPI_Comm communicator = state_->communicator;
  const auto file = state_->opened();
  parallel::collectively(communicator, [&] {
    check_counts(modes);
    const auto mesh = hdf5::open_dataset(file, fmt::format("/mesh/{}/nodes", modes.body));
    if (hdf5::shape_of(mesh.id()).at(0) != static_cast<hsize_t>(modes.nodes->global_rows())) {
      throw std::runtime_error(fmt::format("modes of body {}: its mesh has another number of nodes", modes.body));
    }
  });
  const auto path = [&](const std::string& name) { return fmt::format("/modes/{}/{}", modes.body, name); };
  const auto write_numbers = [&](const std::string& name, const std::string& unit, std::span<const double> values) {
    files::write_from_rank_0(file, path(name), values, communicator);
    parallel::collectively(communicator, [&] { hdf5::put(hdf5::open_dataset(file, path(name)).id(), "unit", unit); });
  };
  write_numbers("frequency", "Hz", modes.frequencies);
  write_numbers("damping_ratio", "1", modes.damping_ratios);
  write_numbers("decay_time", "s", modes.decay_times);
  write_numbers("kinetic_share", "1", modes.kinetic_shares);
  if (!modes.mesh_errors.empty()) {
    write_numbers("mesh_error", "cents", modes.mesh_errors);
  }
  parallel::collectively(communicator, [&] {
    const auto frequency = hdf5::open_dataset(file, path("frequency"));
    hdf5::put(frequency.id(), "mass", modes.mass);
    hdf5::put(frequency.id(), "rigid_motions", modes.rigid_motions);
    hdf5::put_dataset(file, path("kind"), modes.kinds, communicator);
  });
  write_shapes(file, path("shape"), modes);
  state_->new_pictures = true;
}

}  // namespace idiophone::results
