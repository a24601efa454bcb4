#pragma once
// Visibility: the delta of O'Brien 2001, eq. 10, by rays against all bodies and obstacles (Embree).

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/air/radiation/solid_edges.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::radiation {

/// A half-space, bounded by a plane.
struct HalfSpace {
  Vector3 point;   ///< of the plane, m
  Vector3 normal;  ///< out of the half-space

  [[nodiscard]] bool contains(const Vector3& x) const { return normal.dot(x - point) < 0; }
};

/// Bodies and obstacles, which block sound.
struct Occluders {
  std::vector<std::array<Index, 3>> triangles;    ///< of all bodies, body after body: vertices
  std::vector<Index> first_triangle;              ///< [bodies + 1]
  std::vector<float> positions;                   ///< [3 x vertices] initial ones of the bodies, m
  std::vector<std::array<Vector3, 3>> obstacles;  ///< fixed triangles, m
  std::vector<HalfSpace> half_spaces;             ///< unbounded obstacles
};

/// Whether a body's triangles hide each other.
enum class SelfOcclusion {
  included,
  /// A triangle is never hidden by its own body, so that the radiation model alone decides what it contributes.
  excluded
};

/// Visibility of the bodies' triangles from points. A ray is blocked by any triangle, from both sides, but not by the
/// one that it starts on. The same positions give the same answers, regardless of earlier ones.
class Visibility {
 public:
  /// @param self_occlusion  even if it is included, a triangle that faces away from the point is never hidden by its
  ///                        own body: the radiation model decides at once what it contributes, while visibility
  ///                        changes slowly
  /// @throws std::invalid_argument if a triangle names a vertex that does not exist; std::runtime_error if a body is
  ///         farther from the origin than 1e5 times its size, or Embree fails
  Visibility(const Occluders& occluders, SelfOcclusion self_occlusion);
  ~Visibility();
  Visibility(const Visibility&) = delete;
  Visibility& operator=(const Visibility&) = delete;
  Visibility(Visibility&&) = delete;
  Visibility& operator=(Visibility&&) = delete;

  /// Positions of the bodies' vertices, to be changed before move(): [3 x vertices], m. Single precision: 0.1
  /// micrometres at 1 m.
  [[nodiscard]] std::span<float> positions();

  /// Uses the current positions() from now on. Does nothing if one of them is not finite or above 1e9 m: the motion is
  /// unstable then, and the run reports it.
  void move();

  /// Whether a point is visible from the centre of a triangle. True for a point that is not finite.
  /// @param triangle  as numbered in Occluders
  [[nodiscard]] bool sees(Index triangle, const Vector3& point) const;

  /// Whether nothing blocks the way between two points.
  [[nodiscard]] bool is_clear(const Vector3& from, const Vector3& to) const;

  /// The bodies' triangles, where they are now.
  [[nodiscard]] TriangleView view() const;
  /// As in Occluders.
  [[nodiscard]] std::span<const Index> first_triangle() const;

  /// Of a triangle, as numbered in Occluders, m.
  [[nodiscard]] Vector3 centre(Index triangle) const;

 private:
  [[nodiscard]] std::array<Vector3, 3> corners(Index triangle) const;

  struct Bodies;
  std::unique_ptr<Bodies> bodies_;
};

}  // namespace idiophone::radiation
