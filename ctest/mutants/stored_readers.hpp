#pragma once
// What the program reads of HDF5 files, for mutants and for tools/fuzz.

#include <mpi.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "idiophone/run/results/frame_reader.hpp"
#include "idiophone/run/results/mode_reader.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "mesh_outline.hpp"

namespace idiophone::mutants {

/// What `idiophone info` reads of every file.
inline void describe(const std::filesystem::path& file) {
  static_cast<void>(contents::describe(file));
  static_cast<void>(contents::describe_as_json(file));
}

inline void verify(const std::filesystem::path& file) {
  static_cast<void>(results::verify(file));
  results::require_intact(file);
}

inline void read_series(const std::filesystem::path& file) {
  const results::SeriesReader reader(file);
  for (const auto& series : reader.all()) {
    static_cast<void>(reader.read(series));
    reader.require_intact(series);
  }
}

inline void read_sounds(const std::filesystem::path& file) {
  static_cast<void>(results::read_sounds(file));
  static_cast<void>(results::read_references(file));
  static_cast<void>(results::read_modes(file));
}

inline void read_frames(const std::filesystem::path& file) {
  const results::FrameReader reader(file);
  for (std::size_t body = 0; body < reader.bodies().size(); ++body) {
    for (std::size_t frame = 0; frame < reader.times().size(); ++frame) {
      static_cast<void>(reader.displacement(body, frame));
    }
  }
}

inline void read_recording(const std::filesystem::path& file) {
  const results::SurfaceMotionReader reader(file);
  static_cast<void>(reader.read_triangles(0, reader.triangles()));
  static_cast<void>(reader.read_reference(0, reader.vertices()));
  for (std::int64_t row = 0; row < reader.rows(); ++row) {
    static_cast<void>(reader.read_pressure(row, 1, 0, reader.triangles()));
    static_cast<void>(reader.read_position(row, 1, 0, reader.vertices()));
  }
}

/// As ranks read large meshes, of a turned body.
/// @param groups  of elements, with a material for each
inline void read_mesh_in_parts(const std::filesystem::path& file, const std::vector<std::string>& groups) {
  scene::Body body;
  body.name = "plate";
  body.mesh = file;
  body.element = mesh::read_mesh_outline(file).mesh.element;
  body.rotation = {0.1, 0.2, 0.3};
  body.regions.resize(groups.size());
  std::ranges::transform(groups, body.regions.begin(), [](const std::string& group) {
    scene::MaterialRegion region;
    region.name = group;
    return region;
  });
  mesh::MeshShares shares = mesh::read_shares({&body, 1}, MPI_COMM_WORLD);
  static_cast<void>(mesh::read_part({&body, 1}, shares, {}, MPI_COMM_WORLD));
}

}  // namespace idiophone::mutants
