#pragma once
// Regions and fields of membranes and plates.

#include "idiophone/solids/eigenmodes/membrane.hpp"

namespace idiophone::eigenmodes {

inline PlaneField uniform(double value) {
  return [value](double /*x*/, double /*y*/) { return value; };
}

inline mesh::PlaneRegion inside(std::vector<mesh::Point2> polygon) {
  mesh::PlaneRegion region;
  region.outline.polygon = std::move(polygon);
  return region;
}

inline mesh::PlaneRegion disc(double radius) {
  mesh::PlaneRegion region;
  region.outline.radius = radius;
  return region;
}

inline mesh::PlaneRegion rectangle(double length, double width) {
  return inside({{0, 0}, {length, 0}, {length, width}, {0, width}});
}

}  // namespace idiophone::eigenmodes
