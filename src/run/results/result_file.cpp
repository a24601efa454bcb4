#include "idiophone/run/results/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/files/tables.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "result_state.hpp"
#include "series_attributes.hpp"
#include "xdmf.hpp"

namespace idiophone::results {

namespace {

const std::string times_path = "/frames/time";
constexpr hsize_t room_for_a_series = 4096;  ///< its facts and those of its checksums, bytes
constexpr hsize_t chunk_values = 8192;  ///< of a series: 64 kB, large enough to be read fast, small enough to be padded

void check_series(const spectra::Series& series) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("series {}: {}", series.path, why));
  };
  if (!series.path.starts_with('/') || series.path.ends_with('/')) {
    refuse("the path must begin, and not end, with /");
  }
  if (series.columns.empty()) {
    refuse("there must be at least one column");
  }
  if (!std::isfinite(series.rate) || series.rate <= 0.0) {
    refuse(fmt::format("the rate must be above 0 Hz, not {}", series.rate));
  }
  if (!series.positions.empty() && series.positions.size() != series.columns.size()) {
    refuse(fmt::format("there are {} positions for {} columns", series.positions.size(), series.columns.size()));
  }
}

void check_link_name(const std::string& kind, const std::string& name) {
  if (name.empty() || name == "." || name.find('/') != std::string::npos) {
    throw std::runtime_error(
        fmt::format("{} name '{}' can't name a group of the result: it is empty or has a / in it", kind, name));
  }
}

std::string frames_of(const std::string& body) {
  return fmt::format("/frames/{}/displacement", body);
}

}  // namespace

void ResultFile::State::append_frame(const BodyFrame& frame) {
  const auto& nodes = *frame.nodes;
  const std::vector<float> single(frame.displacement.begin(), frame.displacement.end());
  const auto block = nodes.to_blocks(std::span(single), 3);
  const auto frames = dataset(frames_of(frame.body));
  const auto shape = hdf5::shape_of(frames.id());
  parallel::collectively(communicator, [&] {
    if (shape.at(1) != static_cast<hsize_t>(nodes.global_rows())) {
      throw std::runtime_error(
          fmt::format("frame of body {}: {} nodes, but its mesh has {}", frame.body, nodes.global_rows(), shape[1]));
    }
    hdf5::set_rows(frames.id(), shape[0] + 1);
  });
  parallel::on_root(communicator, [&] { hdf5::reserve(file.id(), hdf5::growth(frames.id(), shape[0], 1)); });
  const auto rows = files::block_of(nodes, 3);
  const hdf5::Hyperslab box{.begin = {shape[0], rows.begin[0], 0}, .size = {1, rows.size[0], 3}};
  parallel::collectively(
      communicator, [&] { hdf5::write(frames.id(), box, std::span<const float>(block), hdf5::Transfer::together); });
  add_checksums(frames_of(frame.body), frames, static_cast<std::int64_t>(shape[0]),
                files::checksums_of_rows(std::as_bytes(std::span(block)), 1, communicator));
}

ResultFile::ResultFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
ResultFile::ResultFile(ResultFile&&) noexcept = default;
ResultFile& ResultFile::operator=(ResultFile&&) noexcept = default;
ResultFile::~ResultFile() = default;

ResultFile ResultFile::create(const std::filesystem::path& path, const Origin& origin, MPI_Comm communicator) {
  auto state = std::make_unique<State>(State{
      files::SharedFile{.path = path, .communicator = communicator, .file = hdf5::create_file(path, communicator)}});
  files::write_origin(state->file.id(), files::result_format, origin, communicator);
  const auto file = state->file.id();
  parallel::collectively(communicator, [&] {
    const auto time = files::create_checked_table(file, times_path, H5T_NATIVE_DOUBLE, {}, chunk_values);
    hdf5::put(time.id(), "unit", "s");
  });
  ResultFile result(std::move(state));
  result.flush();
  return result;
}

ResultFile ResultFile::open(const std::filesystem::path& path, MPI_Comm communicator) {
  auto state = std::make_unique<State>(State{
      files::SharedFile{.path = path, .communicator = communicator, .file = hdf5::open_file(path, communicator)}});
  parallel::collectively(communicator, [&] { files::check_format(state->file.id(), files::result_format, path); });
  return ResultFile(std::move(state));
}

void ResultFile::declare(const spectra::Series& series) {
  const auto file = state_->opened();
  parallel::collectively(state_->communicator, [&] {
    check_series(series);
    const auto columns = static_cast<hsize_t>(series.columns.size());
    const auto table = files::create_checked_table(file, series.path, H5T_NATIVE_DOUBLE, {columns},
                                                   std::max<hsize_t>(chunk_values / columns, 1));
    put_series(table.id(), series);
  });
  parallel::on_root(state_->communicator, [&] { hdf5::reserve(file, room_for_a_series); });
}

void ResultFile::append(const std::string& path, std::span<const double> values) {
  const auto file = state_->opened();
  const std::size_t count = parallel::from_root(values.size(), state_->communicator);
  hdf5::Identifier table;
  hdf5::Hyperslab box;
  parallel::collectively(state_->communicator, [&] {
    table = hdf5::open_dataset(file, path);
    box = hdf5::whole(table.id());
    const auto columns = hdf5::can_grow(table.id()) ? hdf5::volume({box.size.begin() + 1, box.size.end()}) : 0;
    if (columns == 0 || count % columns != 0) {
      throw std::runtime_error(fmt::format("can't append {} values to {}: it takes rows of {}", count, path, columns));
    }
    box.begin[0] = std::exchange(box.size[0], count / columns);
    hdf5::set_rows(table.id(), box.begin[0] + box.size[0]);
  });
  std::vector<std::uint32_t> rows;
  parallel::on_root(state_->communicator, [&] {
    hdf5::reserve(file, hdf5::growth(table.id(), box.begin[0], box.size[0]));
    hdf5::write(table.id(), box, values, hdf5::Transfer::alone);
    rows = files::checksums_of_rows(std::as_bytes(values), box.size[0], MPI_COMM_SELF);
  });
  state_->add_checksums(path, table, static_cast<std::int64_t>(box.begin[0]), rows);
}

void ResultFile::add_mesh(const std::string& body, const parallel::Rows& nodes, std::span<const double> reference,
                          const parallel::Rows& cells, std::span<const std::int32_t> cell_nodes, element::Type type) {
  parallel::collectively(state_->communicator, [&] { check_link_name("body", body); });
  const auto file = state_->opened();
  files::write_rows(file, fmt::format("/mesh/{}/nodes", body), nodes, 3, reference);
  files::write_rows(file, fmt::format("/mesh/{}/elements", body), cells,
                    element::reference(type).drawn.nodes_per_cell(), cell_nodes);
  parallel::collectively(state_->communicator, [&] {
    hdf5::put(hdf5::open_dataset(file, fmt::format("/mesh/{}/nodes", body)).id(), "unit", "m");
    const auto frames = files::create_checked_table(file, frames_of(body), H5T_NATIVE_FLOAT,
                                                    {static_cast<hsize_t>(nodes.global_rows()), 3}, 1);
    hdf5::put(frames.id(), "unit", "m");
  });
}

void ResultFile::add_frame(double time, const std::vector<BodyFrame>& bodies) {
  const auto file = state_->opened();
  parallel::collectively(state_->communicator, [&] {
    for (const auto& path : hdf5::datasets_below(file, "/frames")) {
      const auto fits = [&](const auto& body) { return frames_of(body.body) == path; };
      if (path != times_path && std::ranges::none_of(bodies, fits)) {
        throw std::runtime_error(fmt::format("a frame at {} s lacks {}", time, path));
      }
    }
  });
  for (const auto& frame : bodies) {
    state_->append_frame(frame);
  }
  append(times_path, std::span(&time, 1));
  state_->new_pictures = true;
}

void ResultFile::add_reference(const std::string& name, const std::vector<double>& frequencies) {
  const auto file = state_->opened();
  const auto path = fmt::format("/references/{:03}", hdf5::datasets_below(file, "/references").size());
  files::write_from_rank_0(file, path, std::span(frequencies), state_->communicator);
  parallel::collectively(state_->communicator, [&] {
    const auto dataset = hdf5::open_dataset(file, path);
    hdf5::put(dataset.id(), "name", name);
    hdf5::put(dataset.id(), "unit", "Hz");
  });
}

void ResultFile::flush() {
  if (state_->close() && state_->new_pictures) {
    parallel::on_root(state_->communicator, [&] { write_xdmf(state_->path); });
    state_->new_pictures = false;
  }
}

void ResultFile::archive(parallel::Archive& archive) {
  state_->archive(archive, archive_prefix);
  state_->new_pictures |= archive.restoring();
  flush();
}

files::Lengths ResultFile::lengths() {
  return state_->lengths();
}

void ResultFile::truncate(const files::Lengths& lengths) {
  state_->truncate(lengths);
  state_->new_pictures = true;
  flush();
}

}  // namespace idiophone::results
