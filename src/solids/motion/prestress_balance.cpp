#include "idiophone/solids/motion/prestress_balance.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::motion {

namespace {

/// The prestress's forces on this rank's nodes of a body, N. [owned nodes of the body]
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

/// @param scale  the largest force on any node of the body on any rank, held or not, N
/// @throws deck::DeckError where this rank has free nodes that the prestress pulls
void check_free_nodes(const scene::Body& scene_body, const mesh::Part& part, const mesh::BodyPart& body,
                      std::span<const Vector3> forces, double scale) {
  constexpr double rounding = 1e-6;  // also that of a mesh file's coordinates; it moves the body by nothing audible
  const auto worst = std::ranges::max_element(forces, {}, [](const Vector3& force) { return force.norm(); });
  if (worst == forces.end() || worst->norm() <= rounding * scale) {
    return;
  }
  const Vector3& place = part.reference[body.owned_begin + (worst - forces.begin())];
  throw deck::DeckError(
      scene_body.prestress->where,
      fmt::format("bodies.{}.prestress pulls with ({:.3g}, {:.3g}, {:.3g}) N on the node at ({:.4g}, {:.4g}, {:.4g}) "
                  "m, which is free to move that way: the body would not stay at rest. Hold the faces that the stress "
                  "pulls on by `fixed`, or give a stress that pulls on no free face, such as that along a string",
                  scene_body.name, (*worst)[0], (*worst)[1], (*worst)[2], place[0], place[1], place[2]));
}

}  // namespace

void check_prestress(const scene::Solids& solids, const mesh::Part& part, const FiniteElementDynamics& dynamics,
                     MPI_Comm communicator) {
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    if (!solids.bodies[b].prestress) {
      continue;
    }
    const mesh::BodyPart& body = part.bodies[b];
    std::vector<Vector3> forces = forces_at_rest(part, body, dynamics.solid(b));
    const double scale = parallel::largest(largest(forces), communicator);
    for (const Index component : dynamics.constraints().held_components(b)) {
      forces[component / 3 - body.owned_begin][component % 3] = 0.0;
    }
    parallel::collectively(communicator, [&] { check_free_nodes(solids.bodies[b], part, body, forces, scale); });
  }
}

}  // namespace idiophone::motion
