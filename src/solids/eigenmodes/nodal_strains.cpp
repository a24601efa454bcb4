#include "nodal_strains.hpp"

#include <Eigen/LU>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::eigenmodes {

namespace {

using Strain = Eigen::Matrix<double, 6, 1>;

/// @param slope  du_i/dX_k
Strain strain_of_slope(const Eigen::Matrix3d& slope) {
  Strain strain;
  for (int p = 0; p < 6; ++p) {
    const auto [i, k] = solid::direction_pairs[p];
    strain[p] = i == k ? slope(i, i) : slope(i, k) + slope(k, i);
  }
  return strain;
}

/// [element nodes] Gradients of the shape functions at each node.
std::vector<Eigen::MatrixX3d> gradients_at_nodes(element::Type type) {
  std::vector<Eigen::MatrixX3d> gradients;
  for (const Vector3& xi : element::reference(type).nodes) {
    gradients.push_back(element::shape_gradients(type, xi));
  }
  return gradients;
}

}  // namespace

Index region_of(const mesh::Mesh& mesh, Index element) {
  return mesh.regions.empty() ? 0 : mesh.regions[element];
}

std::vector<Eigen::MatrixXd> nodal_strains(const mesh::Mesh& mesh, Index region, const std::vector<bool>& wanted,
                                           const std::vector<Mode>& modes) {
  const auto count = static_cast<Eigen::Index>(mesh.nodes.size());
  const std::vector<Eigen::MatrixX3d> gradients = gradients_at_nodes(mesh.element);
  std::vector<Eigen::MatrixXd> strains(modes.size(), Eigen::MatrixXd::Zero(6, count));
  Eigen::VectorXd elements = Eigen::VectorXd::Zero(count);  // that a node has in the region
  const auto width = static_cast<Eigen::Index>(gradients.size());
  Eigen::Matrix3Xd positions(3, width), motion(3, width);
  for (Index e = 0; e < mesh.element_count(); ++e) {
    if (region_of(mesh, e) != region) {
      continue;
    }
    const auto nodes = mesh.element_nodes(e);
    for (Eigen::Index a = 0; a < width; ++a) {
      positions.col(a) = mesh.nodes[nodes[a]];
    }
    for (std::size_t m = 0; m < modes.size(); ++m) {
      for (Eigen::Index a = 0; a < width; ++a) {
        motion.col(a) = Vector3::Map(&modes[m].shape[3 * static_cast<std::size_t>(nodes[a])]);
      }
      for (Eigen::Index a = 0; a < width; ++a) {
        if (wanted[nodes[a]]) {
          const Eigen::Matrix3d jacobian = positions * gradients[a];
          strains[m].col(nodes[a]) += strain_of_slope(motion * gradients[a] * jacobian.inverse());
        }
      }
    }
    for (const Index node : nodes) {
      elements[node] += 1;
    }
  }
  for (Eigen::MatrixXd& strain : strains) {
    strain.array().rowwise() /= elements.transpose().array().max(1.0);
  }
  return strains;
}

}  // namespace idiophone::eigenmodes
