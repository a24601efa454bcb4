#include "shares_of_strain.hpp"

#include <algorithm>
#include <numeric>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;
using solid::NodeForce;
using solid::NodeState;

namespace {

/// States of nodes at rest whose velocities are the shape, ghosts included.
std::vector<NodeState> moving(const mesh::Part& part, std::span<const double> shape, MPI_Comm communicator) {
  std::vector<double> values(3 * part.node_ids.size());
  std::ranges::copy(shape, values.begin());
  const parallel::Datatype node(3, MPI_DOUBLE);
  const parallel::Handle<PetscSF> ghosts = motion::ghost_exchange(part, communicator);
  petsc(PetscSFBcastBegin(ghosts, node.get(), values.data(), values.data() + shape.size(), MPI_REPLACE));
  petsc(PetscSFBcastEnd(ghosts, node.get(), values.data(), values.data() + shape.size(), MPI_REPLACE));
  std::vector<NodeState> state(part.node_ids.size());
  for (std::size_t c = 0; c < values.size(); ++c) {
    state[c / 3].velocity[c % 3] = values[c];
  }
  return state;
}

}  // namespace

std::vector<double> shares_of_strain(const solid::Solid& solid, const mesh::Part& part, std::span<const double> shape,
                                     double whole, MPI_Comm communicator) {
  if (solid.region_count() == 1 && !solid.is_prestressed()) {
    return {whole};
  }
  const std::vector<NodeState> state = moving(part, shape, communicator);
  std::vector<double> shares(solid.region_count());
  for (std::size_t region = 0; region < shares.size(); ++region) {
    std::vector<NodeForce> force(state.size());
    solid.add_linear_stiffness_force(region, state, force);
    for (std::size_t c = 0; c < shape.size(); ++c) {
      shares[region] -= shape[c] * force[c / 3].component[c % 3];
    }
    shares[region] /= solid.relaxation(region).instantaneous();
  }
  parallel::reduce(shares, MPI_SUM, communicator);
  if (solid.is_prestressed()) {
    return shares;
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) {
    share *= sum > 0 ? whole / sum : 0.0;
  }
  return shares;
}

}  // namespace idiophone::eigenmodes
