#include "idiophone/run/bodies/recorded_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>

#include "idiophone/air/surface/equivalent_radius.hpp"
#include "idiophone/air/surface/spread_radii.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::bodies {

namespace {

constexpr std::int64_t values_kept = 1 << 21;

/// Rows x y z.
std::vector<Vector3> points(const std::vector<double>& rows) {
  std::vector<Vector3> all;
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3) {
    all.emplace_back(rows[i], rows[i + 1], rows[i + 2]);
  }
  return all;
}

std::vector<Index> numbers_from(std::int64_t first, std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), static_cast<Index>(first));
  return numbers;
}

std::vector<double> find_radii(const results::SurfaceMotionReader& reader, const propagation::AudibleSurface& surface) {
  const std::vector<Vector3> reference = points(reader.read_reference(0, reader.vertices()));
  return surface::spread_radii(surface.triangle_ids, surface.first_triangle, [&](std::size_t body) {
    const Index begin = surface.first_triangle[body];
    std::vector<std::array<Vector3, 3>> whole;
    for (const auto& [i, j, k] : reader.read_triangles(begin, surface.first_triangle[body + 1] - begin)) {
      whole.push_back({reference[i], reference[j], reference[k]});
    }
    return whole;
  });
}

/// Radii of this rank's triangles on the surfaces at a row.
std::vector<double> find_radii_at(std::int64_t row, const results::SurfaceMotionReader& reader,
                                  const std::vector<Index>& triangles) {
  std::vector<double> radii(triangles.size(), 1.0);  // of a triangle that neither uses: it is silent
  for (const auto& [first, surface] : reader.surfaces_at(row)) {
    std::vector<Index> numbers;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::int64_t number = triangles[i] - first;
      if (number >= 0 && number < static_cast<std::int64_t>(surface.size())) {
        numbers.push_back(static_cast<Index>(number));
        places.push_back(i);
      }
    }
    const std::vector<double> found = surface::equivalent_radii(surface, numbers);
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!(found[i] > 0.0) || !std::isfinite(found[i])) {
        throw std::runtime_error(
            fmt::format("{}: triangle {} of a segment at row {} has no area", reader.path().string(), numbers[i], row));
      }
      radii[places[i]] = found[i];
    }
  }
  return radii;
}

void read_obstacles(const surface::RecordingHeader& header, propagation::AudibleSurface& surface) {
  const std::vector<Vector3> corners = points(header.obstacle_triangles);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    surface.obstacles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  const std::vector<Vector3> planes = points(header.half_spaces);
  for (std::size_t i = 0; i + 1 < planes.size(); i += 2) {
    surface.half_spaces.push_back({planes[i], planes[i + 1]});
  }
}

/// An even share of the triangles; and of the vertices, extended to all corners of the triangles.
void read_share(const results::SurfaceMotionReader& reader, int rank, int ranks, propagation::AudibleSurface& surface) {
  const auto begin_of = [ranks](std::int64_t count, int part) { return count * part / ranks; };
  const std::int64_t first = begin_of(reader.triangles(), rank);
  surface.triangles = reader.read_triangles(first, begin_of(reader.triangles(), rank + 1) - first);
  surface.triangle_ids = numbers_from(first, surface.triangles.size());
  std::int64_t begin = begin_of(reader.vertices(), rank);
  std::int64_t end = begin_of(reader.vertices(), rank + 1);
  for (const mesh::Triangle& triangle : surface.triangles) {
    const auto [low, high] = std::ranges::minmax(triangle);
    begin = std::min<std::int64_t>(begin, low);
    end = std::max<std::int64_t>(end, high + 1);
  }
  for (mesh::Triangle& triangle : surface.triangles) {
    for (Index& vertex : triangle) {
      vertex -= static_cast<Index>(begin);
    }
  }
  surface.vertex_ids = numbers_from(begin, end - begin);
  surface.reference = points(reader.read_reference(begin, end - begin));
}

/// Bodies by the recording's name, and by their own where there are several, or where the recording has no name.
void read_bodies(const std::string& name, const results::SurfaceMotionReader& reader,
                 propagation::AudibleSurface& surface) {
  const std::vector<surface::BodyOffsets>& bodies = reader.header().bodies;
  for (const surface::BodyOffsets& body : bodies) {
    surface.bodies.push_back(name.empty() ? body.name : bodies.size() == 1 ? name : name + "_" + body.name);
    surface.first_triangle.push_back(body.first_triangle);
    surface.first_vertex.push_back(body.first_vertex);
  }
  surface.first_triangle.push_back(static_cast<Index>(reader.triangles()));
  surface.first_vertex.push_back(static_cast<Index>(reader.vertices()));
}

propagation::AudibleSurface recorded_surface(const std::string& name, const results::SurfaceMotionReader& reader,
                                             const scene::Radiation& radiation, RecordedObstacles obstacles,
                                             MPI_Comm communicator) {
  propagation::AudibleSurface surface;
  parallel::collectively(communicator, [&] {
    if (reader.has_segments() && radiation.model == scene::RadiationModel::waves) {
      throw std::runtime_error(
          fmt::format("{}: its triangles change over time, which model waves can't follow; choose "
                      "kirchhoff, or another model",
                      reader.path().string()));
    }
    surface.fade_step = reader.has_segments() ? 1.0 / (surface::fade_of_changes * reader.header().rate) : 0.0;
    read_share(reader, parallel::rank_of(communicator), parallel::size_of(communicator), surface);
    read_bodies(name, reader, surface);
    if (radiation.needs_radii()) {
      surface.radii =
          reader.has_segments() ? find_radii_at(0, reader, surface.triangle_ids) : find_radii(reader, surface);
    }
    if (obstacles == RecordedObstacles::keep) {
      read_obstacles(reader.header(), surface);
    }
  });
  return surface;
}

}  // namespace

RecordedSource::RecordedSource(std::string name, results::SurfaceMotionReader reader, const scene::Radiation& radiation,
                               RecordedObstacles obstacles, MPI_Comm communicator)
    : Source(recorded_surface(name, reader, radiation, obstacles, communicator)),
      name_(std::move(name)),
      reader_(std::move(reader)),
      first_triangle_(surface().triangle_ids.empty() ? 0 : surface().triangle_ids.front()),
      first_vertex_(surface().vertex_ids.empty() ? 0 : surface().vertex_ids.front()),
      communicator_(communicator) {}

void RecordedSource::start(surface::SurfaceMotion& motion) {
  parallel::collectively(communicator_, [&] { take(0, motion); });
}

void RecordedSource::advance(surface::SurfaceMotion& motion) {
  ++sample_;
  try {
    take(std::min(sample_, samples()), motion);
  } catch (const std::runtime_error& error) {
    problem_ = error.what();
  }
  if (sample_ > samples()) {
    std::ranges::fill(motion.pressure, 0.0);
  }
}

void RecordedSource::check() {
  parallel::agree(communicator_, problem_);
}

void RecordedSource::archive(parallel::Archive& archive) {
  archive.root("recording/" + name_ + "/sample", sample_);
}

void RecordedSource::take(std::int64_t row, surface::SurfaceMotion& motion) {
  if (row < begin_ || row >= end_) {
    read_rows(row);
  }
  const auto copy = [&](const std::vector<double>& rows, std::size_t width, std::size_t length,
                        std::vector<double>& values) {
    values.resize(length);
    const auto begin = static_cast<std::size_t>(row - begin_) * width;
    std::ranges::copy(std::span(rows).subspan(begin, width), values.begin());
  };
  const std::size_t triangles = surface().triangles.size();
  const std::size_t vertices = surface().reference.size();
  copy(pressure_, triangles, padded(triangles), motion.pressure);
  copy(position_, 3 * vertices, surface::SurfaceMotion::position_length(vertices), motion.position);
  if (reader_.has_segments() && !surface().radii.empty()) {
    if (const std::int64_t stage = reader_.stage_at(row); stage != stage_) {
      radii_ = find_radii_at(row, reader_, surface().triangle_ids);
      stage_ = stage;
    }
    motion.radii = radii_;
  }
}

void RecordedSource::read_rows(std::int64_t row) {
  const auto triangles = static_cast<std::int64_t>(surface().triangles.size());
  const auto vertices = static_cast<std::int64_t>(surface().reference.size());
  const std::int64_t rows = std::clamp<std::int64_t>(values_kept / std::max<std::int64_t>(triangles + 3 * vertices, 1),
                                                     1, reader_.rows() - row);
  pressure_ = reader_.read_pressure(row, rows, first_triangle_, triangles);
  position_ = reader_.read_position(row, rows, first_vertex_, vertices);
  begin_ = row;
  end_ = row + rows;
}

}  // namespace idiophone::bodies
