#include "idiophone/motion/outset.hpp"

#include <algorithm>

#include "idiophone/mesh/broadcast.hpp"
#include "idiophone/motion/static_equilibrium.hpp"

namespace idiophone::motion {

double Outset::stable_step() const {
  return std::ranges::min_element(steps, {}, &StableStep::step)->step;
}

Outset find_outset(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes, const Attachments& attachments,
                   contact::Partners& partners) {
  const mesh::Part whole = mesh::distribute(meshes, MPI_COMM_SELF);
  const Dynamics dynamics(scene, whole, attachments);
  Outset outset;
  for (const mesh::BodyPart& body : whole.bodies) {
    double mass = 0.0;
    Vector3 moment = Vector3::Zero();
    for (auto node = static_cast<std::size_t>(body.owned_begin); node < static_cast<std::size_t>(body.owned_end);
         ++node) {
      mass += dynamics.mass()[node];
      moment += dynamics.mass()[node] * whole.reference[node];
    }
    outset.masses.push_back(mass);
    outset.centres.emplace_back(moment / mass);
  }
  outset.steps = find_stable_steps(scene, whole, dynamics);
  stiffen_by_contact(scene, dynamics, partners, outset.steps);
  outset.displacement = static_equilibrium(scene, whole, attachments, dynamics);
  return outset;
}

Outset broadcast(Outset outset, MPI_Comm communicator) {
  mesh::broadcast(outset.steps, communicator);
  mesh::broadcast(outset.masses, communicator);
  mesh::broadcast(outset.centres, communicator);
  mesh::broadcast(outset.displacement, communicator);
  return outset;
}

}  // namespace idiophone::motion
