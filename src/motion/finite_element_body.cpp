#include "finite_element_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

namespace idiophone::motion {

namespace {

/// How much older the velocities are than the displacements, s.
double age_of_velocities(const Step& step) {
  return step.is_first() ? 0.0 : step.length / 2;
}

}  // namespace

FiniteElementBody::FiniteElementBody(const scene::Scene& scene, const mesh::Part& part, const Constraints& constraints,
                                     std::size_t number, std::span<double> lumped)
    : part_(part),
      body_(part.bodies[number]),
      constraints_(constraints),
      number_(number),
      name_(scene.bodies[number].name),
      gravity_(scene.gravity),
      mass_damping_(scene.materials[scene.bodies[number].material].damping.mass),
      solid_(body_, part.reference, scene.materials[scene.bodies[number].material],
             scene.bodies[number].material_axes()),
      mass_(make_mass(scene, lumped)) {}

solid::Mass FiniteElementBody::make_mass(const scene::Scene& scene, std::span<double> lumped) {
  solid_.add_mass(lumped);
  return {body_, lumped, added_mass(scene, lumped)};
}

solid::AddedMass FiniteElementBody::added_mass(const scene::Scene& scene, std::span<const double> lumped) {
  const scene::Body& body = scene.bodies[number_];
  if (!body.mass_scaling) {
    return {};
  }
  const scene::Material& material = scene.materials[body.material];
  const double highest = std::min(scene.audio.max_frequency, solid::highest_audible);
  return {body_, part_.reference, lumped.subspan(body_.owned_begin, body_.owned_end - body_.owned_begin),
          constraints_.held_components(number_), [&](double thickness) {
            const auto scaling = solid::choose_scaling(material, thickness, highest, body.mass_scaling->shift);
            predicted_shift_ =
                std::max(predicted_shift_, solid::predicted_shift(scaling, material, thickness, highest));
            return scaling;
          }};
}

void FiniteElementBody::start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) {
  for (Index node = body_.owned_begin; node < body_.owned_end; ++node) {
    const Vector3 arm = part_.reference[node] - centre;
    const Vector3 velocity = body.velocity + body.spin.cross(arm);
    std::copy_n(velocity.data(), 3, state[node].velocity);
  }
}

void FiniteElementBody::advance(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                                ReproducibleSum& work) {
  // The first step starts from velocities at time 0: half a kick, all of its damping from them.
  const double kick = step.is_first() ? step.length / 2 : step.length;
  const double implicit = step.is_first() ? 0.0 : mass_damping_ * kick / 2;
  const double explicit_part = step.is_first() ? mass_damping_ * kick : mass_damping_ * kick / 2;
  const double keep = (1 - explicit_part) / (1 + implicit);
  const double gain = kick / (1 + implicit);
  mass_.accelerate({keep, gain, gravity_}, age_of_velocities(step), force, state);
  constraints_.steer(number_, step, mass_, state, work);
  const std::size_t owned = body_.owned_end - body_.owned_begin;
  solid::update_displacements(step.length, state.subspan(body_.owned_begin, owned));
}

void FiniteElementBody::find_velocities(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                                        std::span<NodeState> now) const {
  mass_.solve(state, age_of_velocities(step), force, [&](Index node, const Vector3& by_force) {
    for (int i = 0; i < 3; ++i) {
      const double half = state[node].velocity[i];
      const double acceleration = by_force[i] + gravity_[i] - mass_damping_ * half;
      now[node].velocity[i] = step.is_first() ? half : half + step.length / 2 * acceleration;
    }
  });
  // A held component's force is the constraint's business: it keeps the velocity that it was steered with.
  const std::span<const Index> held = constraints_.held_components(number_);
  std::vector<double> steered;
  std::ranges::transform(held, std::back_inserter(steered),
                         [&](Index component) { return state[component / 3].velocity[component % 3]; });
  (void)mass_.impose(held, steered, now);
}

void FiniteElementBody::archive(parallel::Archive& archive) {
  if (!solid_.has_memory()) {
    return;
  }
  std::vector<Index> elements = body_.element_ids;  // ghosts have the same rows as their owners'
  for (Index& element : elements) {
    element -= body_.first_element;
  }
  archive.rows("motion/memory/" + name_, parallel::Rows(elements, body_.global_elements, archive.communicator()),
               [this](std::size_t element, parallel::ArchiveRow& row) { solid_.archive_memory(element, row); });
}

}  // namespace idiophone::motion
