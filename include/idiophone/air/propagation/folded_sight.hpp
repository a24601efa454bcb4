#pragma once
// What is seen by way of a floor or of the walls of a room.

#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/scene/radiation_section.hpp"

namespace idiophone::propagation {

/// Ways end at a receiver or at one of its mirror images, as image_paths() have them: they are folded where they cross
/// the planes that reflect.
class FoldedSight {
 public:
  /// Both have to outlive this object.
  FoldedSight(const radiation::Visibility& visibility, const scene::Radiation& section)
      : visibility_(visibility), section_(section) {}

  [[nodiscard]] const radiation::Visibility& visibility() const { return visibility_; }

  /// Whether nothing blocks the way from the centre of a triangle; as radiation::Visibility::sees().
  [[nodiscard]] bool sees(Index triangle, const Vector3& end) const;
  /// Whether nothing blocks the way between two points.
  [[nodiscard]] bool is_clear(const Vector3& begin, const Vector3& end) const;
  /// Whether a place is above the floor and inside the room.
  [[nodiscard]] bool is_in_air(const Vector3& place) const;

 private:
  /// Whether nothing blocks the parts of a folded way from one of them on.
  [[nodiscard]] bool is_clear_from(std::size_t part, const std::vector<Vector3>& way) const;

  const radiation::Visibility& visibility_;
  const scene::Radiation& section_;
};

}  // namespace idiophone::propagation
