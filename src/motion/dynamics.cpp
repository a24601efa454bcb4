#include "idiophone/motion/dynamics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace idiophone::motion {

Dynamics::Dynamics(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments)
    : part_(part), loads_(scene, part, attachments), constraints_(scene, part, attachments), gravity_(scene.gravity) {
  std::vector<double> lumped(part.node_ids.size());
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const auto& material = scene.materials[scene.bodies[b].material];
    solids_.emplace_back(part.bodies[b], part.reference, material, scene.bodies[b].material_axes());
    solids_.back().add_mass(lumped);
    masses_.emplace_back(part.bodies[b], lumped, added_mass(scene, part, b, std::span(lumped)));
    mass_damping_.push_back(material.damping.mass);
  }
}

solid::AddedMass Dynamics::added_mass(const scene::Scene& scene, const mesh::Part& part, std::size_t b,
                                      std::span<const double> lumped) {
  double& shift = predicted_shift_.emplace_back(0.0);
  const scene::Body& body = scene.bodies[b];
  if (!body.mass_scaling) {
    return {};
  }
  const mesh::BodyPart& here = part.bodies[b];
  const scene::Material& material = scene.materials[body.material];
  const double highest = std::min(scene.audio.max_frequency, solid::highest_audible);
  return {here, part.reference, lumped.subspan(here.owned_begin, here.owned_end - here.owned_begin),
          constraints_.held_components(b), [&](double thickness) {
            const auto scaling = solid::choose_scaling(material, thickness, highest, body.mass_scaling->shift);
            shift = std::max(shift, solid::predicted_shift(scaling, material, thickness, highest));
            return scaling;
          }};
}

void Dynamics::begin_memory(double step) {
  for (auto& solid : solids_) {
    solid.begin_memory(step);
  }
}

void Dynamics::compute_force(double time, const NodeState* state, NodeForce* force) const {
  std::fill_n(force, part_.node_ids.size(), NodeForce{});
  for (const auto& solid : solids_) {
    solid.add_internal_force(state, force);
  }
  loads_.add(time, state, force);
}

void Dynamics::compute_force_and_remember(double time, const NodeState* state, NodeForce* force) {
  std::fill_n(force, part_.node_ids.size(), NodeForce{});
  for (auto& solid : solids_) {
    solid.add_internal_force_and_remember(state, force);
  }
  loads_.add(time, state, force);
}

void Dynamics::advance(std::int64_t number, double step, NodeForce* force, NodeState* state,
                       ReproducibleSum& work) const {
  const bool first = number == 0;
  for (std::size_t b = 0; b < part_.bodies.size(); ++b) {
    // The first step starts from velocities at time 0: half a kick, all of its damping from them.
    const double kick = first ? step / 2 : step;
    const double implicit = first ? 0.0 : mass_damping_[b] * kick / 2;
    const double explicit_part = first ? mass_damping_[b] * kick : mass_damping_[b] * kick / 2;
    const double keep = (1 - explicit_part) / (1 + implicit);
    const double gain = kick / (1 + implicit);
    masses_[b].accelerate({keep, gain, gravity_}, first ? 0.0 : step / 2, force, state);
  }
  constraints_.steer(static_cast<double>(number + 1) * step, step, masses_, state, work);
  loads_.add_work(static_cast<double>(number) * step, step, state, work);
  solid::update_displacements(step, {state, static_cast<std::size_t>(part_.owned_nodes)});
}

void Dynamics::whole_step_velocities(double step, bool first, NodeForce* force, const NodeState* state,
                                     std::vector<Vector3>& velocity) const {
  velocity.resize(part_.owned_nodes);
  std::vector<NodeState> now(state, state + part_.owned_nodes);
  for (std::size_t b = 0; b < part_.bodies.size(); ++b) {
    masses_[b].solve(state, first ? 0.0 : step / 2, force, [&](Index node, const Vector3& by_force) {
      for (int i = 0; i < 3; ++i) {
        const double half = state[node].velocity[i];
        const double acceleration = by_force[i] + gravity_[i] - mass_damping_[b] * half;
        now[node].velocity[i] = first ? half : half + step / 2 * acceleration;
      }
    });
    // A held component's force is the constraint's business: it keeps the velocity that it was steered with.
    const std::span<const Index> held = constraints_.held_components(b);
    std::vector<double> steered;
    std::ranges::transform(held, std::back_inserter(steered),
                           [&](Index component) { return state[component / 3].velocity[component % 3]; });
    (void)masses_[b].impose(held, steered, now.data());
  }
  std::ranges::transform(now, velocity.begin(), [](const NodeState& node) { return Vector3(node.velocity); });
}

void Dynamics::start(const scene::Scene& scene, const std::vector<Vector3>& centres, NodeState* state) const {
  for (std::size_t b = 0; b < part_.bodies.size(); ++b) {
    for (Index node = part_.bodies[b].owned_begin; node < part_.bodies[b].owned_end; ++node) {
      const Vector3 arm = part_.reference[node] - centres[b];
      const Vector3 velocity = scene.bodies[b].velocity + scene.bodies[b].spin.cross(arm);
      std::copy_n(velocity.data(), 3, state[node].velocity);
    }
  }
  constraints_.place(0.0, state);
}

}  // namespace idiophone::motion
