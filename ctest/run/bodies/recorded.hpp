#pragma once
// A recording whose every number is known.

#include "idiophone/air/surface/recording.hpp"
#include "idiophone/run/results/surface_motion_file.hpp"
#include "shared_folder.hpp"

namespace idiophone::bodies {

constexpr std::int32_t recorded_triangles = 7, recorded_vertices = 9;
constexpr std::int64_t recorded_rows = 5;

inline double recorded_pressure(std::int64_t row, std::int32_t triangle) {
  return support::value_of(static_cast<std::int32_t>(row), triangle);
}

inline double recorded_position(std::int64_t row, std::int32_t vertex, int axis) {
  return support::value_of(vertex, 3 * static_cast<int>(row) + axis);
}

/// Six vertices with four triangles, and three with three; from sample -2 on.
inline surface::RecordingHeader recorded_header() {
  surface::RecordingHeader header;
  header.rate = 8000;
  header.first_sample = -2;
  header.samples = 100;
  header.air_density = 1.2;
  header.air_speed = 340;
  header.bodies = {{"plate", 0, 0}, {"hammer", 4, 6}};
  header.obstacle_triangles = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  header.half_spaces = {0, 0, -1, 0, 0, 1};
  return header;
}

/// Writes it; all of it is rank 0's. Collective.
/// @param scale  of all pressures
inline void record_surface(const std::filesystem::path& path,
                           const surface::RecordingHeader& header = recorded_header(), double scale = 1.0) {
  std::vector<Index> triangles, vertices, corners;
  std::vector<double> reference;
  for (std::int32_t i = 0; support::rank() == 0 && i < recorded_triangles; ++i) {
    triangles.push_back(i);
    const std::int32_t first = i < 4 ? i % 3 : 6;
    corners.insert(corners.end(), {first, first + (i < 4 ? 3 : 1), first + 2});
  }
  for (std::int32_t i = 0; support::rank() == 0 && i < recorded_vertices; ++i) {
    vertices.push_back(i);
    reference.insert(reference.end(), {0.1 * i, 0.01 * i * i, 0.3});
  }
  const parallel::Rows triangle_rows(triangles, recorded_triangles, MPI_COMM_WORLD);
  const parallel::Rows vertex_rows(vertices, recorded_vertices, MPI_COMM_WORLD);
  auto file = results::SurfaceMotionFile::create(path, header, {&triangle_rows, &vertex_rows, corners, reference},
                                                 MPI_COMM_WORLD);
  for (std::int64_t row = 0; row < recorded_rows; ++row) {
    std::vector<double> pressure, position;
    for (const Index triangle : triangles) {
      pressure.push_back(scale * recorded_pressure(row, triangle));
    }
    for (const Index vertex : vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        position.push_back(recorded_position(row, vertex, axis));
      }
    }
    file.append(1, pressure, position);
  }
  file.flush();
}

}  // namespace idiophone::bodies
