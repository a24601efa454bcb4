#pragma once
// What the program reads of HDF5 files, for mutants and for tools/fuzz.

#include <nlohmann/json.hpp>

#include "idiophone/run/results/frame_reader.hpp"
#include "idiophone/run/results/mode_reader.hpp"
#include "idiophone/run/results/series_reader.hpp"
#include "idiophone/run/results/sound_reader.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/study/contents/describe.hpp"

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

}  // namespace idiophone::mutants
