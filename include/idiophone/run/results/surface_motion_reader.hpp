#pragma once
// Reading a recorded surface motion of a run or of another simulator, in each process independently.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/run/results/surface_motion_file.hpp"

namespace idiophone::results {

class SurfaceMotionReader {
 public:
  /// Defaults for what other simulators may omit: no deck, one body, air of 1.21 kg/m3 and 343 m/s, sound up to the
  /// last row, undeformed positions as in row 0.
  /// @throws std::runtime_error, naming what is wrong, if the file can't be opened, is no recording, or contradicts
  ///         itself.
  explicit SurfaceMotionReader(const std::filesystem::path& path);
  SurfaceMotionReader(SurfaceMotionReader&&) noexcept;
  SurfaceMotionReader& operator=(SurfaceMotionReader&&) noexcept;
  SurfaceMotionReader(const SurfaceMotionReader&) = delete;
  SurfaceMotionReader& operator=(const SurfaceMotionReader&) = delete;
  ~SurfaceMotionReader();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] const surface::RecordingHeader& header() const;
  [[nodiscard]] std::int64_t rows() const;       ///< audio samples
  [[nodiscard]] std::int64_t triangles() const;  ///< of all bodies
  [[nodiscard]] std::int64_t vertices() const;   ///< of all bodies

  /// Whether the triangles change over time. They are then read as triangles that stay, in two banks that take turns
  /// (docs/use/surface_motion.md).
  [[nodiscard]] bool has_segments() const;

  /// A whole surface of a segment.
  struct Surface {
    std::int64_t first_triangle = 0;                ///< that its triangles are read as
    std::vector<std::array<Vector3, 3>> triangles;  ///< at the segment's first row, three corners each, m
  };
  /// A number that differs between rows of different surfaces_at(); only where has_segments().
  [[nodiscard]] std::int64_t stage_at(std::int64_t row) const;
  /// Surface of the segment with a row, and of the segment before or after it whose triangles wait; only where
  /// has_segments().
  /// @throws std::runtime_error if they can't be read
  [[nodiscard]] std::vector<Surface> surfaces_at(std::int64_t row) const;

  /// Global vertex numbers of the triangles [begin, begin + count).
  /// @throws std::runtime_error if they can't be read, or a vertex isn't there
  [[nodiscard]] std::vector<std::array<std::int32_t, 3>> read_triangles(std::int64_t begin, std::int64_t count) const;

  /// Undeformed positions of the vertices [begin, begin + count), [3 x count], m.
  [[nodiscard]] std::vector<double> read_reference(std::int64_t begin, std::int64_t count) const;

  /// Pressures of the triangles [begin, begin + count) in the rows [row, row + rows), [count x rows], Pa.
  [[nodiscard]] std::vector<double> read_pressure(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                  std::int64_t count) const;

  /// Positions of the vertices [begin, begin + count) in the rows [row, row + rows), [3 x count x rows], m.
  [[nodiscard]] std::vector<double> read_position(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                  std::int64_t count) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::results
