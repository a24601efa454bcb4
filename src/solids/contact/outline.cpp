#include "idiophone/solids/contact/outline.hpp"

#include <cmath>

#include "polyhedron.hpp"

namespace idiophone::contact {

namespace {

/// A tetrahedron that holds the box.
Tetrahedron around(const Box& box) {
  const double side = 2 * box.sizes().norm();  // the sphere inside has a radius of side/sqrt(3)
  const Vector3 centre = box.center();
  return Tetrahedron({centre + side * Vector3(1, 1, 1), centre + side * Vector3(-1, 1, -1),
                      centre + side * Vector3(1, -1, -1), centre + side * Vector3(-1, -1, 1)});
}

}  // namespace

std::vector<std::array<Vector3, 3>> outline(const RigidShape& shape) {
  std::vector<std::array<Vector3, 3>> triangles;
  Polyhedron polyhedron;
  for (std::size_t part = 0; part < shape.boxes.size(); ++part) {
    if (!std::isfinite(shape.boxes[part].sizes().norm())) {
      continue;
    }
    polyhedron.become(around(shape.boxes[part]));
    constexpr int first_number = 4;  // the tetrahedron's own faces have smaller ones
    for (Index plane = shape.first_plane[part]; plane < shape.first_plane[part + 1]; ++plane) {
      polyhedron.clip(shape.planes[plane], first_number + plane);
    }
    for (std::size_t place = 0; place < polyhedron.face_count(); ++place) {
      const auto [number, corners] = polyhedron.face(place);
      if (number < first_number || shape.exterior[number - first_number] == 0) {
        continue;
      }
      for (std::size_t i = 2; i < corners.size(); ++i) {
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
      }
    }
  }
  return triangles;
}

}  // namespace idiophone::contact
