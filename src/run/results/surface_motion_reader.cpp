#include "idiophone/run/results/surface_motion_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "recording_header.hpp"
#include "segmented_motion.hpp"
#include "surface_motion_paths.hpp"

namespace idiophone::results {

namespace {

hdf5::Identifier open_table(hid_t file, const std::string& name, const std::vector<hsize_t>& inner,
                            const std::filesystem::path& path) {
  require(has_dataset(file, name), path, fmt::format("there is no {}", name));
  auto table = hdf5::open_dataset(file, name);
  const auto shape = hdf5::shape_of(table.id());
  const bool fits = shape.size() == inner.size() + 1;
  require(fits, path, fmt::format("{} has {} dimensions, expected {}", name, shape.size(), inner.size() + 1));
  for (std::size_t i = 0; i < inner.size(); ++i) {
    require(inner[i] == 0 || shape[i + 1] == inner[i], path,
            fmt::format("{} has rows of {}, expected {}", name, shape[i + 1], inner[i]));
  }
  return table;
}

/// What a recording with segments must not have beside them.
void refuse_beside_segments(hid_t file, const std::filesystem::path& path) {
  for (const std::string& name : {surface_motion::triangles, surface_motion::pressure, surface_motion::position,
                                  surface_motion::reference, surface_motion::body_names}) {
    require(!has_dataset(file, name), path,
            fmt::format("there is a {} beside /segments, whose triangles change", name));
  }
}

}  // namespace

struct SurfaceMotionReader::State {
  std::filesystem::path path;
  surface::RecordingHeader header;
  hdf5::Identifier file, triangles, reference, pressure, position;
  std::unique_ptr<const SegmentedMotion> segments;  ///< of a recording whose triangles change, instead of the tables
  std::int64_t rows = 0, triangle_count = 0, vertex_count = 0;

  explicit State(const std::filesystem::path& recording) : path(recording), file(hdf5::open_for_reading(recording)) {
    files::read_within_limit(path, [&] { read(); });
  }

  void read() {
    files::check_format(file.id(), files::surface_motion_format, path);
    if (SegmentedMotion::is_in(file.id())) {
      read_segments();
      return;
    }
    triangles = open_table(file.id(), surface_motion::triangles, {3}, path);
    pressure = open_table(file.id(), surface_motion::pressure, {0}, path);
    position = open_table(file.id(), surface_motion::position, {0, 3}, path);
    if (has_dataset(file.id(), surface_motion::reference)) {
      reference = open_table(file.id(), surface_motion::reference, {3}, path);
    }
    read_shapes();
    read_header();
  }

  void read_segments() {
    refuse_beside_segments(file.id(), path);
    const double rate = read_recording_rate(file.id(), path);
    const auto fade_rows = static_cast<std::int64_t>(std::llround(surface::fade_of_changes * rate));
    segments = std::make_unique<const SegmentedMotion>(file.id(), path, fade_rows);
    rows = segments->rows();
    triangle_count = segments->triangles();
    vertex_count = segments->vertices();
    read_header();
  }

  template <class T>
  [[nodiscard]] std::vector<T> read_box(const hdf5::Identifier& table, const hdf5::Hyperslab& box) const {
    return files::read_naming(path, [&] { return hdf5::read<T>(table.id(), box); });
  }

  void read_shapes() {
    const auto size = [](const hdf5::Identifier& table, std::size_t dimension) {
      return static_cast<std::int64_t>(hdf5::shape_of(table.id()).at(dimension));
    };
    rows = size(position, 0);
    triangle_count = size(triangles, 0);
    vertex_count = size(position, 1);
    require(size(pressure, 0) == rows, path,
            fmt::format("/pressure has {} rows and /position {}", size(pressure, 0), rows));
    require(rows > 0, path, "nothing is recorded in it");
    require(size(pressure, 1) == triangle_count && triangle_count > 0, path,
            fmt::format("/pressure has {} columns for {} triangles", size(pressure, 1), triangle_count));
    require(!reference.open() || size(reference, 0) == vertex_count, path,
            fmt::format("/reference does not have {} rows, one for each vertex", vertex_count));
  }

  void read_header() {
    header =
        read_recording_header(file.id(), path, {.rows = rows, .triangles = triangle_count, .vertices = vertex_count});
  }
};

SurfaceMotionReader::SurfaceMotionReader(const std::filesystem::path& path) : state_(std::make_unique<State>(path)) {}
SurfaceMotionReader::SurfaceMotionReader(SurfaceMotionReader&&) noexcept = default;
SurfaceMotionReader& SurfaceMotionReader::operator=(SurfaceMotionReader&&) noexcept = default;
SurfaceMotionReader::~SurfaceMotionReader() = default;

const std::filesystem::path& SurfaceMotionReader::path() const {
  return state_->path;
}

const surface::RecordingHeader& SurfaceMotionReader::header() const {
  return state_->header;
}

bool SurfaceMotionReader::has_segments() const {
  return state_->segments != nullptr;
}

std::int64_t SurfaceMotionReader::stage_at(std::int64_t row) const {
  return state_->segments->stage_at(row);
}

std::vector<SurfaceMotionReader::Surface> SurfaceMotionReader::surfaces_at(std::int64_t row) const {
  return state_->segments->surfaces_at(row);
}

std::int64_t SurfaceMotionReader::rows() const {
  return state_->rows;
}

std::int64_t SurfaceMotionReader::triangles() const {
  return state_->triangle_count;
}

std::int64_t SurfaceMotionReader::vertices() const {
  return state_->vertex_count;
}

std::vector<std::array<std::int32_t, 3>> SurfaceMotionReader::read_triangles(std::int64_t begin,
                                                                             std::int64_t count) const {
  if (state_->segments) {
    return SegmentedMotion::triangles_of(begin, count);
  }
  const auto numbers = state_->read_box<std::int32_t>(
      state_->triangles, {{static_cast<hsize_t>(begin), 0}, {static_cast<hsize_t>(count), 3}});
  std::vector<std::array<std::int32_t, 3>> triangles(count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    require(numbers[i] >= 0 && numbers[i] < state_->vertex_count, state_->path,
            fmt::format("triangle {} has vertex {}; there are {}", begin + static_cast<std::int64_t>(i / 3), numbers[i],
                        state_->vertex_count));
    triangles[i / 3][i % 3] = numbers[i];
  }
  return triangles;
}

std::vector<double> SurfaceMotionReader::read_reference(std::int64_t begin, std::int64_t count) const {
  if (state_->segments) {
    return state_->segments->read_reference(begin, count);
  }
  if (!state_->reference.open()) {
    return read_position(0, 1, begin, count);
  }
  return state_->read_box<double>(state_->reference,
                                  {{static_cast<hsize_t>(begin), 0}, {static_cast<hsize_t>(count), 3}});
}

std::vector<double> SurfaceMotionReader::read_pressure(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                       std::int64_t count) const {
  if (state_->segments) {
    return state_->segments->read_pressure(row, rows, begin, count);
  }
  return state_->read_box<double>(state_->pressure, {{static_cast<hsize_t>(row), static_cast<hsize_t>(begin)},
                                                     {static_cast<hsize_t>(rows), static_cast<hsize_t>(count)}});
}

std::vector<double> SurfaceMotionReader::read_position(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                       std::int64_t count) const {
  if (state_->segments) {
    return state_->segments->read_position(row, rows, begin, count);
  }
  return state_->read_box<double>(state_->position, {{static_cast<hsize_t>(row), static_cast<hsize_t>(begin), 0},
                                                     {static_cast<hsize_t>(rows), static_cast<hsize_t>(count), 3}});
}

}  // namespace idiophone::results
