#include "shares_of_strain.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "with_ghosts.hpp"

namespace idiophone::eigenmodes {

using solid::NodeForce;
using solid::NodeState;

namespace {

/// States of nodes at rest whose velocities are the shape, ghosts included.
std::vector<NodeState> moving(const mesh::Part& part, std::span<const double> shape, MPI_Comm communicator) {
  const std::vector<double> values = with_ghosts(part, shape, communicator);
  std::vector<NodeState> state(part.node_ids.size());
  for (std::size_t c = 0; c < values.size(); ++c) {
    state[c / 3].velocity[c % 3] = values[c];
  }
  return state;
}

bool has_directional_loss(const StrainedRegion& strained) {
  return strained.solid->has_directional_loss(strained.region);
}

/// x^T K x over the owned nodes, with this elasticity in a region.
/// @param state  velocities x, ghosts included
double stiffness_term(const StrainedRegion& strained, const solid::Elasticity& elasticity,
                      const std::vector<NodeState>& state, std::span<const double> shape) {
  std::vector<NodeForce> force(state.size());
  strained.solid->add_linear_stiffness_force(strained.region, elasticity, state, force);
  double sum = 0.0;
  for (std::size_t c = 0; c < shape.size(); ++c) {
    sum -= shape[c] * force[c / 3].component[c % 3];
  }
  return sum;
}

/// Sums over ranks.
void add_up(std::vector<StrainedRegion>& regions, MPI_Comm communicator) {
  std::vector<double> sums;
  for (const StrainedRegion& strained : regions) {
    sums.insert(sums.end(), {strained.share, strained.relaxing});
  }
  parallel::reduce(sums, MPI_SUM, communicator);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    regions[r].share = sums[2 * r];
    regions[r].relaxing = sums[2 * r + 1];
  }
}

}  // namespace

std::vector<StrainedRegion> shares_of_strain(const motion::FiniteElementDynamics& dynamics, const mesh::Part& part,
                                             std::span<const double> shape, double whole, MPI_Comm communicator) {
  std::vector<StrainedRegion> regions;
  bool is_prestressed = false;
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const solid::Solid& solid = dynamics.solid(b);
    is_prestressed = is_prestressed || solid.is_prestressed();
    for (std::size_t region = 0; region < solid.region_count(); ++region) {
      regions.push_back({&solid, region, 0.0, 0.0});
    }
  }
  const bool is_directional = std::ranges::any_of(regions, has_directional_loss);
  if (regions.size() == 1 && !is_prestressed && !is_directional) {
    regions.front().share = regions.front().relaxing = whole;
    return regions;
  }
  const std::vector<NodeState> state = moving(part, shape, communicator);
  for (StrainedRegion& strained : regions) {
    const solid::Solid& solid = *strained.solid;
    strained.share = stiffness_term(strained, solid.elasticity(strained.region), state, shape);
    strained.relaxing = has_directional_loss(strained)
                            ? stiffness_term(strained, solid.relaxing_elasticity(strained.region), state, shape)
                            : strained.share;
  }
  add_up(regions, communicator);
  double sum = 0.0;
  for (const StrainedRegion& strained : regions) {
    sum += strained.share;
  }
  const double scale = is_prestressed ? 1.0 : sum > 0 ? whole / sum : 0.0;
  for (StrainedRegion& strained : regions) {
    strained.share *= scale;
    strained.relaxing *= scale;
  }
  return regions;
}

std::vector<double> shares_of_joints(const joints::Joints& joints, const mesh::Part& part,
                                     std::span<const double> shape, MPI_Comm communicator) {
  std::vector<double> shares(joints.all().size());
  if (shares.empty()) {
    return shares;
  }
  const std::vector<NodeState> state = moving(part, shape, communicator);
  Eigen::VectorXd moved;
  for (std::size_t joint = 0; joint < shares.size(); ++joint) {
    joints.for_each_stiffness(joint, [&](std::span<const Index> nodes, const Eigen::MatrixXd& stiffness) {
      if (nodes.front() >= part.owned_nodes) {
        return;  // another rank's
      }
      moved.resize(stiffness.rows());
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        moved.segment<3>(3 * static_cast<Eigen::Index>(a)) = Vector3(state[nodes[a]].velocity);
      }
      shares[joint] += moved.dot(stiffness * moved);
    });
  }
  parallel::reduce(shares, MPI_SUM, communicator);
  return shares;
}

}  // namespace idiophone::eigenmodes
