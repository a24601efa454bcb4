#pragma once
// Directions of blows, continued over the surface.

#include <span>
#include <vector>

#include "idiophone/study/measured_maps/measured_deck.hpp"

namespace idiophone::measured_maps {

/// A blow shows the displacement along its own direction only. Between blows, the direction of the displacement is
/// interpolated. Blows from opposite sides of a wall show the same motion with opposite signs, so a direction that is
/// opposite to that of the nearest blow before it in the list is turned round.
class BlowDirections {
 public:
  explicit BlowDirections(std::span<const RecordedBlow> blows);

  /// Unit vectors at places: the mean of the directions, each with the weight of one over its distance squared; that of
  /// the nearest blow where the mean vanishes.
  [[nodiscard]] std::vector<Vector3> at(std::span<const Vector3> places) const;

  /// Changes the signs of strengths of blows, [blows], for the directions that are turned round.
  void turn(std::vector<double>& strength) const;

 private:
  std::vector<Vector3> places_;
  std::vector<Vector3> directions_;
  std::vector<double> sign_;  // -1: turned round
};

}  // namespace idiophone::measured_maps
