#include "surface_weights.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone::proxies {

void weigh_surface(const TetrahedralMesh& mesh, const std::function<bool(const Vector3& area)>& is_heard,
                   Rows& weights) {
  std::ranges::fill(weights, Row{});
  for (const auto& [a, b, c] : mesh.surface) {
    const Vector3 area = 0.5 * (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
    if (is_heard(area)) {
      const RowLanes share = row_of(area / 3.0).lanes;
      weights[a].lanes += share;
      weights[b].lanes += share;
      weights[c].lanes += share;
    }
  }
}

}  // namespace idiophone::proxies
