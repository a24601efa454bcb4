#include "idiophone/run/results/surface_motion_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/shared_file.hpp"
#include "idiophone/files/table_checksums.hpp"
#include "idiophone/files/tables.hpp"
#include "surface_motion_paths.hpp"

namespace idiophone::results {

namespace {

constexpr hsize_t row_chunk_values = 1U << 17U;  ///< 1 MB: many rows of a small surface, one of a large one

/// [width x columns x rows] to [width x rows x columns].
std::vector<double> transposed(std::span<const double> values, std::size_t rows, std::size_t columns,
                               std::size_t width) {
  std::vector<double> turned(values.size());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      std::copy_n(&values[(row * columns + column) * width], width, &turned[(column * rows + row) * width]);
    }
  }
  return turned;
}

/// What the ranks have of some audio samples, as this rank's block of each row of the file.
/// @param values  [width x local places x rows]
std::vector<double> blocks(const parallel::Rows& places, std::span<const double> values, std::size_t rows,
                           std::size_t width) {
  parallel::collectively(places.communicator(), [&] {
    const std::size_t expected = places.local_rows() * width * rows;
    if (values.size() != expected) {
      throw std::runtime_error(fmt::format("surface motion: found {} values, expected {}", values.size(), expected));
    }
  });
  const auto local = transposed(values, rows, places.local_rows(), width);
  const auto block = places.to_blocks(std::span<const double>(local), static_cast<int>(width * rows));
  return transposed(block, places.block_rows(), rows, width);
}

hsize_t rows_per_chunk(hsize_t values_per_row) {
  return std::max<hsize_t>(row_chunk_values / values_per_row, 1);
}

void write_bodies(hid_t file, const std::vector<surface::BodyOffsets>& bodies, MPI_Comm communicator) {
  std::vector<std::string> names;
  std::vector<std::int32_t> first_triangles, first_vertices;
  for (const auto& body : bodies) {
    names.push_back(body.name);
    first_triangles.push_back(body.first_triangle);
    first_vertices.push_back(body.first_vertex);
  }
  files::write_from_rank_0(file, surface_motion::first_triangles, std::span<const std::int32_t>(first_triangles),
                           communicator);
  files::write_from_rank_0(file, surface_motion::first_vertices, std::span<const std::int32_t>(first_vertices),
                           communicator);
  parallel::collectively(communicator,
                         [&] { hdf5::put_dataset(file, surface_motion::body_names, names, communicator); });
}

void create_table(hid_t file, const std::string& path, const hdf5::Dimensions& row, const std::string& unit) {
  const auto table = files::create_checked_table(file, path, H5T_NATIVE_DOUBLE, row, rows_per_chunk(hdf5::volume(row)));
  hdf5::put(table.id(), "unit", unit);
}

}  // namespace

struct SurfaceMotionFile::State : files::SharedFile {
  const parallel::Rows* triangles = nullptr;
  const parallel::Rows* vertices = nullptr;

  /// @param values  [width x local places x rows]
  void append(const std::string& name, const parallel::Rows& places, std::span<const double> values, hsize_t rows,
              hsize_t width) {
    const auto block = blocks(places, values, rows, width);
    const auto table = dataset(name);
    auto box = hdf5::whole(table.id());
    box.begin[0] = std::exchange(box.size[0], rows);
    box.begin[1] = static_cast<hsize_t>(places.block_begin());
    box.size[1] = static_cast<hsize_t>(places.block_rows());
    parallel::collectively(communicator, [&] { hdf5::set_rows(table.id(), box.begin[0] + rows); });
    parallel::on_root(communicator, [&] { hdf5::reserve(file.id(), hdf5::growth(table.id(), box.begin[0], rows)); });
    parallel::collectively(
        communicator, [&] { hdf5::write(table.id(), box, std::span<const double>(block), hdf5::Transfer::together); });
    add_checksums(name, table, static_cast<std::int64_t>(box.begin[0]),
                  files::checksums_of_rows(std::as_bytes(std::span(block)), rows, communicator));
  }

  /// @throws std::runtime_error unless the tables are as wide as the surface
  void require_surface() const {
    const auto width = [&](const std::string& name) {
      return static_cast<std::int64_t>(hdf5::shape_of(hdf5::open_dataset(file.id(), name).id()).at(1));
    };
    if (width(surface_motion::pressure) != triangles->global_rows() ||
        width(surface_motion::position) != vertices->global_rows()) {
      throw std::runtime_error(fmt::format("{} records another surface; start the run anew", path.string()));
    }
  }
};

SurfaceMotionFile::SurfaceMotionFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
SurfaceMotionFile::SurfaceMotionFile(SurfaceMotionFile&&) noexcept = default;
SurfaceMotionFile& SurfaceMotionFile::operator=(SurfaceMotionFile&&) noexcept = default;
SurfaceMotionFile::~SurfaceMotionFile() = default;

SurfaceMotionFile SurfaceMotionFile::create(const std::filesystem::path& path, const surface::RecordingHeader& header,
                                            const surface::RecordedSurface& surface, MPI_Comm communicator) {
  auto state = std::make_unique<State>(State{
      files::SharedFile{.path = path, .communicator = communicator, .file = hdf5::create_file(path, communicator)},
      surface.triangles, surface.vertices});
  const auto file = state->file.id();
  files::write_origin(file, files::surface_motion_format, header.origin, communicator);
  parallel::collectively(communicator, [&] {
    hdf5::put(file, "rate", header.rate);
    hdf5::put(file, "first_sample", header.first_sample);
    hdf5::put(file, "samples", header.samples);
    hdf5::put(file, "air_density", header.air_density);
    hdf5::put(file, "air_speed", header.air_speed);
  });
  write_bodies(file, header.bodies, communicator);
  files::write_from_rank_0(file, surface_motion::obstacle_triangles, std::span(header.obstacle_triangles),
                           communicator);
  files::write_from_rank_0(file, surface_motion::half_spaces, std::span(header.half_spaces), communicator);
  files::write_rows(file, surface_motion::triangles, *surface.triangles, 3, surface.corners);
  files::write_rows(file, surface_motion::reference, *surface.vertices, 3, surface.reference);
  parallel::collectively(communicator, [&] {
    create_table(file, surface_motion::pressure, {static_cast<hsize_t>(surface.triangles->global_rows())}, "Pa");
    create_table(file, surface_motion::position, {static_cast<hsize_t>(surface.vertices->global_rows()), 3}, "m");
  });
  SurfaceMotionFile recording(std::move(state));
  recording.flush();
  return recording;
}

SurfaceMotionFile SurfaceMotionFile::open(const std::filesystem::path& path, const surface::RecordedSurface& surface,
                                          MPI_Comm communicator) {
  auto state = std::make_unique<State>(
      State{files::SharedFile{.path = path, .communicator = communicator, .file = hdf5::open_file(path, communicator)},
            surface.triangles, surface.vertices});
  parallel::collectively(communicator, [&] {
    files::check_format(state->file.id(), files::surface_motion_format, path);
    state->require_surface();
  });
  return SurfaceMotionFile(std::move(state));
}

void SurfaceMotionFile::append(std::int64_t rows, std::span<const double> pressure, std::span<const double> position) {
  state_->append(surface_motion::pressure, *state_->triangles, pressure, static_cast<hsize_t>(rows), 1);
  state_->append(surface_motion::position, *state_->vertices, position, static_cast<hsize_t>(rows), 3);
}

void SurfaceMotionFile::archive(parallel::Archive& archive) {
  state_->archive(archive, archive_prefix);
  flush();
}

void SurfaceMotionFile::flush() {
  state_->close();
}

}  // namespace idiophone::results
