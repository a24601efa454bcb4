#include "finite_element_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "idiophone/solids/motion/kick.hpp"

namespace idiophone::motion {

namespace {

/// See StableStep.
double highest_loss(const scene::Solids& solids, const scene::Body& body) {
  double highest = 0.0;
  for (const scene::MaterialRegion& region : body.all_regions()) {
    const auto& loss = solids.materials[region.material].damping.loss;
    highest = std::max(highest, loss ? loss->band[1] : 0.0);
  }
  return highest;
}

/// How much older the velocities are than the displacements, s.
double age_of_velocities(const Step& step) {
  return step.is_first() ? 0.0 : step.length / 2;
}

/// Adds what one node has, all in BodyUnits and s.
/// @param mass  lumped
/// @param arm   X - C
void add_node(BodySums& sums, double mass, const Vector3& arm, const Vector3& displacement, const Vector3& velocity,
              const Vector3& momentum) {
  const Vector3 weighted = mass * displacement;
  add(sums.displacement, weighted);
  add(sums.momentum, momentum);
  add(sums.angular_momentum, (arm + displacement).cross(momentum));
  add(sums.cross_moment, weighted * arm.transpose());
  add(sums.second_moment, weighted * displacement.transpose());
  sums.kinetic.add(momentum.dot(velocity) / 2);
}

}  // namespace

FiniteElementBody::FiniteElementBody(const scene::Solids& solids, const mesh::Part& part,
                                     const Constraints& constraints, std::size_t number, MassScaling scaling,
                                     std::span<double> lumped)
    : name_(solids.bodies[number].name),
      highest_loss_(highest_loss(solids, solids.bodies[number])),
      part_(part),
      body_(part.bodies[number]),
      constraints_(constraints),
      number_(number),
      gravity_(solids.gravity),
      mass_damping_(solids.materials[solids.bodies[number].material].damping.of_all_motion()),
      solid_(body_, part.reference, solid::oriented_materials(solids.bodies[number], solids.materials)),
      mass_(make_mass(solids, scaling, lumped)) {}

solid::Mass FiniteElementBody::make_mass(const scene::Solids& solids, MassScaling scaling, std::span<double> lumped) {
  solid_.add_mass(lumped);
  return {body_, lumped, scaling == MassScaling::none ? solid::AddedMass() : added_mass(solids, lumped)};
}

solid::AddedMass FiniteElementBody::added_mass(const scene::Solids& solids, std::span<const double> lumped) {
  const scene::Body& body = solids.bodies[number_];
  if (!body.mass_scaling) {
    return {};
  }
  const scene::Material& material = solids.materials[body.material];
  const double highest = std::min(solids.max_frequency, solid::highest_audible);
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

void FiniteElementBody::advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                                           ReproducibleSum& work) {
  mass_.accelerate(kick_of(step, mass_damping_, gravity_), age_of_velocities(step), force, state);
  constraints_.steer(number_, step, mass_, state, work);
}

void FiniteElementBody::advance_displacements(const Step& step, std::span<NodeState> state) {
  const std::size_t owned = body_.owned_end - body_.owned_begin;
  solid::update_displacements(step.length, state.subspan(body_.owned_begin, owned));
}

std::vector<Vector3> FiniteElementBody::find_velocities(const Step& step, std::span<NodeForce> force,
                                                        std::span<const NodeState> state) const {
  std::vector<NodeState> now(body_.owned_end);
  std::ranges::copy(state.subspan(body_.owned_begin, body_.owned_end - body_.owned_begin),
                    now.begin() + body_.owned_begin);
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
  mass_.impose(held, steered, now);
  std::vector<Vector3> velocity;
  std::ranges::transform(now, std::back_inserter(velocity),
                         [](const NodeState& node) { return Vector3(node.velocity); });
  return velocity;
}

std::vector<double> FiniteElementBody::inverse_masses() const {
  std::vector<double> inverse;
  std::ranges::transform(mass_.lumped(), std::back_inserter(inverse), [](double mass) { return 1 / mass; });
  std::vector<int> held(inverse.size());
  for (const Index component : constraints_.held_components(number_)) {
    const std::size_t node = component / 3 - body_.owned_begin;
    inverse[node] = ++held[node] == 3 ? 0.0 : inverse[node];
  }
  return inverse;
}

void FiniteElementBody::add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                                 const Vector3& centre, const BodyUnits& unit, std::span<BodySums> sums) const {
  const std::vector<Vector3> velocity = find_velocities(step, force, state);
  const auto sums_of = [&](Index node) -> BodySums& {
    return sums[sums.size() == 1 ? 0 : part_.pieces[node] - part_.first_piece[number_]];
  };
  mass_.multiply(state, velocity, [&](Index node, const Vector3& momentum) {
    const Eigen::Map<const Vector3> displacement(state[node].displacement);
    add_node(sums_of(node), mass_.lumped(node) / unit.mass, (part_.reference[node] - centre) / unit.length,
             displacement / unit.length, velocity[node], momentum / unit.mass);
  });
  // A body that can break has no added mass.
  for (const Eigen::Matrix3d& moment : mass_.added_second_moments(state)) {
    add(sums.front().added_moment, moment / (unit.mass * unit.length * unit.length));
  }
  std::vector<double> energy(body_.element_ids.size());
  solid_.elastic_energy(state, energy);
  for (std::size_t element = 0; element < energy.size(); ++element) {
    if (body_.owned[element] != 0) {
      sums_of(body_.element_nodes(element)[0]).elastic.add(energy[element] / unit.mass);
    }
  }
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
