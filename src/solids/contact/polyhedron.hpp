#pragma once
// A convex polyhedron that planes cut down: the overlap of two cells.

#include <span>
#include <vector>

#include "tetrahedron.hpp"

namespace idiophone::contact {

class Polyhedron {
 public:
  /// Becomes a tetrahedron; face number f is the one opposite corner f.
  void become(const Tetrahedron& tetrahedron);

  /// Cuts off what is outside of a plane; the face that the cut makes gets the number `face`.
  void clip(const Plane& plane, int face);

  [[nodiscard]] bool empty() const { return faces_.empty(); }

  /// Volume, m3, and its first moment, m4.
  struct Moments {
    double volume = 0.0;
    Vector3 first = Vector3::Zero();
  };
  [[nodiscard]] Moments moments() const;

  /// One face: the number it was given and its corners around the outward normal.
  struct Polygon {
    int number = 0;
    std::span<const Vector3> corners;  ///< m
  };
  [[nodiscard]] std::size_t face_count() const { return faces_.size(); }
  [[nodiscard]] Polygon face(std::size_t place) const;

 private:
  struct CornerRange {
    int number;
    std::size_t first, last;  ///< in corners_
  };
  void clip_face(const CornerRange& face);
  void close(int number);

  std::vector<CornerRange> faces_, new_faces_;
  std::vector<Vector3> corners_, new_corners_;
  std::vector<double> distances_;                  ///< [corners_] from the cutting plane, m
  double tiny_ = 0.0;                              ///< length below which round-off decides, m
  std::vector<std::array<Vector3, 2>> cut_edges_;  ///< of the face that the cut makes, in its own direction
};

}  // namespace idiophone::contact
