#pragma once
// Surfaces of boxes, for tests.

#include <cmath>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::advice {

struct Surface {
  std::vector<Vector3> nodes;
  std::vector<mesh::Triangle> triangles;
};

/// Adds a box, each face cut into n x n squares.
inline void add_box(Surface& surface, const Vector3& low, const Vector3& high, int n) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int u, int v) {
            Vector3 place = upper ? high : low;
            place[(axis + 1) % 3] = std::lerp(low[(axis + 1) % 3], high[(axis + 1) % 3], static_cast<double>(u) / n);
            place[(axis + 2) % 3] = std::lerp(low[(axis + 2) % 3], high[(axis + 2) % 3], static_cast<double>(v) / n);
            surface.nodes.push_back(place);
            return static_cast<Index>(surface.nodes.size()) - 1;
          };
          const Index a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
          surface.triangles.push_back(upper ? mesh::Triangle{a, b, c} : mesh::Triangle{a, c, b});
          surface.triangles.push_back(upper ? mesh::Triangle{a, c, d} : mesh::Triangle{a, d, c});
        }
      }
    }
  }
}

}  // namespace idiophone::advice
