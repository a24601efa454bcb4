#include "idiophone/motion/initial_state.hpp"

#include <algorithm>

#include "idiophone/parallel/broadcast.hpp"
#include "static_equilibrium.hpp"

namespace idiophone::motion {

double InitialState::stable_step() const {
  return std::ranges::min_element(steps, {}, &StableStep::step)->step;
}

InitialState mass_properties(const Dynamics& dynamics, const mesh::Part& whole) {
  InitialState initial_state;
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
    initial_state.masses.push_back(mass);
    initial_state.centres.push_back(centre);
    initial_state.moments.push_back(second_moment);
  }
  return initial_state;
}

namespace {

/// @param steps  stable steps with scaling
std::vector<ScalingEffect> scaling_effects(scene::Scene scene, const mesh::Part& whole, const Attachments& attachments,
                                           const Dynamics& dynamics, const std::vector<StableStep>& steps) {
  std::vector<ScalingEffect> effects(steps.size());
  if (std::ranges::none_of(scene.bodies, [](const scene::Body& body) { return body.mass_scaling.has_value(); })) {
    return effects;
  }
  for (scene::Body& body : scene.bodies) {
    body.mass_scaling.reset();
  }
  const std::vector<StableStep> without = find_stable_steps(scene, whole, Dynamics(scene, whole, attachments));
  for (std::size_t b = 0; b < steps.size(); ++b) {
    effects[b].gain = steps[b].is_limited() ? steps[b].step / without[b].step : 1.0;
    effects[b].shift = dynamics.predicted_shift(b);
  }
  return effects;
}

}  // namespace

InitialState find_initial_state(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes,
                                const Attachments& attachments, contact::ContactSurfaces& contact_surfaces) {
  const mesh::Part whole = mesh::distribute(meshes, MPI_COMM_SELF);
  const Dynamics dynamics(scene, whole, attachments);
  InitialState initial_state = mass_properties(dynamics, whole);
  initial_state.steps = find_stable_steps(scene, whole, dynamics);
  initial_state.scaling = scaling_effects(scene, whole, attachments, dynamics, initial_state.steps);
  stiffen_by_contact(scene, dynamics, contact_surfaces, initial_state.steps);
  initial_state.displacement = static_equilibrium(scene, whole, attachments, dynamics);
  return initial_state;
}

InitialState broadcast(InitialState initial_state, MPI_Comm communicator) {
  parallel::broadcast(initial_state.steps, communicator);
  parallel::broadcast(initial_state.scaling, communicator);
  parallel::broadcast(initial_state.masses, communicator);
  parallel::broadcast(initial_state.centres, communicator);
  parallel::broadcast(initial_state.moments, communicator);
  parallel::broadcast(initial_state.displacement, communicator);
  return initial_state;
}

}  // namespace idiophone::motion
