#pragma once
// One rank's share of a recorded surface motion: a range of its triangles, with the vertices that they need.

#include <cstdint>
#include <vector>

#include "idiophone/mesh/mesh.hpp"
#include "idiophone/source/audible_surface.hpp"
#include "idiophone/store/surface_motion_reader.hpp"
#include "idiophone/surface/surface_motion.hpp"

namespace idiophone::source {

class RecordedMotion {
 public:
  /// @param reader  must outlive this object
  /// @throws std::runtime_error when the triangles can't be read
  RecordedMotion(const store::SurfaceMotionReader& reader, int rank, int ranks);

  /// These triangles, and the recorded obstacles.
  /// @param with_radii  reads the undeformed surface of all bodies
  /// @throws std::runtime_error when it can't be read
  [[nodiscard]] AudibleSurface surface(bool with_radii) const;

  /// Gives the rows one after the other, from row 0 on. Reads as many at once as fit into some 16 MB.
  /// @throws std::runtime_error when they can't be read, or there are no more
  void take(surface::SurfaceMotion& motion);

 private:
  void read_rows();

  const store::SurfaceMotionReader& reader_;
  std::int64_t first_triangle_ = 0;
  std::vector<mesh::Triangle> triangles_;
  std::int64_t first_vertex_ = 0;
  std::int64_t vertices_ = 0;
  std::int64_t row_ = 0;    ///< the next one
  std::int64_t begin_ = 0;  ///< first row in memory
  std::int64_t end_ = 0;    ///< one past the last
  std::vector<double> pressure_;
  std::vector<double> position_;
};

}  // namespace idiophone::source
