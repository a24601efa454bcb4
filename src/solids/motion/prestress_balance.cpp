#include "idiophone/solids/motion/prestress_balance.hpp"

#include <algorithm>
#include <optional>

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::motion {

namespace {

/// The prestress's forces on this rank's nodes of the undeformed body, N. [owned nodes of the body]
std::vector<Vector3> forces_at_rest(const mesh::Part& part, const mesh::BodyPart& body, const solid::Solid& solid) {
  const std::vector<NodeState> at_rest(part.node_ids.size());
  std::vector<NodeForce> force(part.node_ids.size());
  solid.add_internal_force(at_rest, force);
  std::vector<Vector3> own;
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    own.emplace_back(force[node].component);
  }
  return own;
}

double largest(const std::vector<Vector3>& forces) {
  double most = 0.0;
  for (const Vector3& force : forces) {
    most = std::max(most, force.norm());
  }
  return most;
}

}  // namespace

std::vector<char> deformed_by_prestress(const scene::Solids& solids, const mesh::Part& part,
                                        const FiniteElementDynamics& dynamics, MPI_Comm communicator) {
  constexpr double rounding = 1e-6;  // also that of a mesh file's coordinates; it moves the body by nothing audible
  std::vector<char> deformed(solids.bodies.size());
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    const std::optional<scene::Prestress>& prestress = solids.bodies[b].prestress;
    if (!prestress || prestress->stretch) {
      deformed[b] = prestress ? 1 : 0;
      continue;
    }
    const mesh::BodyPart& body = part.bodies[b];
    std::vector<Vector3> forces = forces_at_rest(part, body, dynamics.solid(b));
    const double scale = parallel::largest(largest(forces), communicator);
    for (const Index component : dynamics.constraints().held_components(b)) {
      forces[component / 3 - body.owned_begin][component % 3] = 0.0;
    }
    deformed[b] = parallel::largest(largest(forces), communicator) > rounding * scale ? 1 : 0;
  }
  return deformed;
}

}  // namespace idiophone::motion
