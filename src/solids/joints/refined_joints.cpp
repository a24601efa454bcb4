#include "idiophone/solids/joints/refined_joints.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::joints {

namespace {

/// The weights of one body at a point, in the numbers of its mesh.
struct BodyWeights {
  std::span<NodeWeight> weights;  ///< ascending by node
  Index first_node = 0;

  /// [nodes x 3] value and slopes.
  [[nodiscard]] Eigen::MatrixX3d table() const {
    Eigen::MatrixX3d rows(std::ssize(weights), 3);
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      rows.row(row) << weights[row].value, weights[row].slope[0], weights[row].slope[1];
    }
    return rows;
  }
  void add(const Eigen::MatrixX3d& rows) const {
    for (Eigen::Index row = 0; row < rows.rows(); ++row) {
      weights[row].value += rows(row, 0);
      weights[row].slope[0] += rows(row, 1);
      weights[row].slope[1] += rows(row, 2);
    }
  }
};

/// [refined nodes x given nodes] The motion of the refined nodes that is a motion of the given ones.
Eigen::MatrixXd interpolation(const BodyWeights& given, const BodyWeights& refined, const mesh::RefinedMesh& mesh) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(std::ssize(refined.weights), std::ssize(given.weights));
  for (Eigen::Index row = 0; row < rows.rows(); ++row) {
    for (const mesh::Parent& parent : mesh.parents[refined.weights[row].node - refined.first_node]) {
      const auto place = std::ranges::lower_bound(given.weights, parent.node + given.first_node, {}, &NodeWeight::node);
      rows(row, place - given.weights.begin()) = parent.weight;
    }
  }
  return rows;
}

void match(const BodyWeights& given, const BodyWeights& refined, const mesh::RefinedMesh& mesh) {
  const Eigen::MatrixXd motion = interpolation(given, refined, mesh);
  const Eigen::LLT<Eigen::MatrixXd> gram(motion.transpose() * motion);
  const Eigen::MatrixX3d lacking = given.table() - motion.transpose() * refined.table();
  refined.add(motion * gram.solve(lacking));
}

/// Global numbers of the first nodes of refined meshes.
std::vector<Index> first_nodes(const std::vector<mesh::RefinedMesh>& refined) {
  std::vector<Index> first = {0};
  for (const mesh::RefinedMesh& body : refined) {
    first.push_back(first.back() + static_cast<Index>(body.mesh.nodes.size()));
  }
  return first;
}

/// Of one surface of a joint.
std::span<NodeWeight> weights_of(MeshedJoint& joint, const JointPoint& point, std::size_t side) {
  const std::array<Index, 3> bounds = {point.first_begin, point.second_begin, point.end};
  return std::span(joint.weights).subspan(bounds.at(side), bounds.at(side + 1) - bounds.at(side));
}

}  // namespace

void act_as(std::vector<MeshedJoint> given, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
            const std::vector<mesh::RefinedMesh>& refined, std::vector<MeshedJoint>& joints) {
  const std::vector<Index> first = mesh::offsets(meshes).nodes, refined_first = first_nodes(refined);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j].normal = given[j].normal;
    joints[j].tangential = given[j].tangential;
    const scene::Joint& joint = solids.joints[given[j].joint];
    for (std::size_t p = 0; p < (joint.is_layer() ? 0 : joints[j].points.size()); ++p) {
      for (const std::size_t side : {0, 1}) {
        const std::size_t body = joint.surfaces[side].body;
        match({weights_of(given[j], given[j].points[p], side), first[body]},
              {weights_of(joints[j], joints[j].points[p], side), refined_first[body]}, refined[body]);
      }
    }
  }
}

}  // namespace idiophone::joints
