#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

std::vector<double> nodal_areas(std::span<const Triangle> triangles, std::span<const Vector3> nodes) {
  std::vector<double> areas(nodes.size());
  for (const Triangle& triangle : triangles) {
    const auto corner = [&](std::size_t k) -> const Vector3& { return nodes[triangle.at(k)]; };
    const double area = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    for (const Index node : triangle) {
      areas[node] += area / 3.0;
    }
  }
  return areas;
}

}  // namespace idiophone::mesh
