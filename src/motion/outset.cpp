#include "idiophone/motion/outset.hpp"

#include <algorithm>

#include "idiophone/motion/static_equilibrium.hpp"
#include "idiophone/parallel/broadcast.hpp"

namespace idiophone::motion {

double Outset::stable_step() const {
  return std::ranges::min_element(steps, {}, &StableStep::step)->step;
}

Outset weigh(const Dynamics& dynamics, const mesh::Part& whole) {
  Outset outset;
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    const auto for_each_node = [&](auto visit) {
      for (Index node = whole.bodies[b].owned_begin; node < whole.bodies[b].owned_end; ++node) {
        visit(dynamics.mass(b).lumped(node), whole.reference[node]);
      }
    };
    double mass = 0.0;
    Vector3 first_moment = Vector3::Zero();
    for_each_node([&](double share, const Vector3& place) {
      mass += share;
      first_moment += share * place;
    });
    const Vector3 centre = first_moment / mass;
    Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
    for_each_node([&](double share, const Vector3& place) {
      second_moment += share * (place - centre) * (place - centre).transpose();
    });
    outset.masses.push_back(mass);
    outset.centres.push_back(centre);
    outset.moments.push_back(second_moment);
  }
  return outset;
}

Outset find_outset(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes, const Attachments& attachments,
                   contact::Partners& partners) {
  const mesh::Part whole = mesh::distribute(meshes, MPI_COMM_SELF);
  const Dynamics dynamics(scene, whole, attachments);
  Outset outset = weigh(dynamics, whole);
  outset.steps = find_stable_steps(scene, whole, dynamics);
  stiffen_by_contact(scene, dynamics, partners, outset.steps);
  outset.displacement = static_equilibrium(scene, whole, attachments, dynamics);
  return outset;
}

Outset broadcast(Outset outset, MPI_Comm communicator) {
  parallel::broadcast(outset.steps, communicator);
  parallel::broadcast(outset.masses, communicator);
  parallel::broadcast(outset.centres, communicator);
  parallel::broadcast(outset.moments, communicator);
  parallel::broadcast(outset.displacement, communicator);
  return outset;
}

}  // namespace idiophone::motion
