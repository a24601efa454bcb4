#pragma once
// Gauges of a deck: channels of how bodies deform.

#include <cstddef>
#include <string>
#include <vector>

#include "idiophone/scene/body.hpp"

namespace idiophone::scene {

/// Two or three points of bodies, and what is measured between them; see bodies::measured().
struct Gauge {
  enum class Quantity {
    distance,  ///< of two points, m
    strain,    ///< relative change of the distance of two points
    angle,     ///< at the second of three points, rad
    curvature  ///< of the circle through three points, 1/m
  };
  /// A point of a surface, or a patch whose mean point is taken.
  struct Point {
    std::size_t body = 0;  ///< index into Scene::bodies
    PatchPlace place;
  };
  std::string name;
  Quantity quantity = Quantity::distance;
  std::vector<Point> points;

  /// How many points a quantity has.
  [[nodiscard]] static std::size_t points_of(Quantity quantity) {
    return quantity == Quantity::distance || quantity == Quantity::strain ? 2 : 3;
  }
};

}  // namespace idiophone::scene
