#include "accelerated_body.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/solids/motion/kick.hpp"

namespace idiophone::motion {

using Displacements = accelerated::AcceleratedSolid::Displacements;

namespace {

/// What of a body an accelerator can't step; empty: nothing.
std::string unsuitable(const scene::Body& body, const solid::Solid& solid) {
  if (body.mass_scaling) {
    return "mass_scaling";
  }
  if (!body.fracture.empty()) {
    return "fracture";
  }
  for (std::size_t region = 0; region < solid.region_count(); ++region) {
    if (solid.has_directional_loss(region)) {
      return "a loss_factor by direction";
    }
  }
  return "";
}

}  // namespace

AcceleratedBody::AcceleratedBody(accelerator::Accelerator& accelerator, const scene::Solids& solids,
                                 const mesh::Part& part, const Constraints& constraints, std::size_t number,
                                 MassScaling scaling, std::span<double> lumped)
    : FiniteElementBody(solids, part, constraints, number, scaling, lumped), accelerator_(accelerator) {
  const scene::Body& body = solids.bodies[number];
  if (const std::string what = unsuitable(body, solid()); !what.empty()) {
    throw std::runtime_error("body " + body.name + ": an accelerator can't step a body with " + what +
                             "; leave it out, or leave --accelerator out, or, if the deck has waves on a grid, add "
                             "--accelerate waves");
  }
  if (!body.driven.empty()) {
    for (const Index component : constraints.held_components(number)) {
      steered_.push_back(component / 3);
    }
    keep_each_once(steered_);
  }
}

void AcceleratedBody::begin(double step) {
  FiniteElementBody::begin(step);
  // Where a group is driven, the processor has to know how free nodes would move.
  const auto held = steered_.empty() ? constraints_.held_components(number_) : std::span<const Index>();
  there_.emplace(accelerator_, body_, part_.reference, solid_, mass_, held, step);
  ghosts_.emplace(there_->list(there_->ghosts()));
  exchanged_ = steered_;
  exchanged_.insert(exchanged_.end(), there_->shared().begin(), there_->shared().end());
  needs_velocities_ = !steered_.empty() || part_.owned_nodes < static_cast<Index>(part_.node_ids.size());
  choose_nodes({}, 1);
}

std::vector<Index> AcceleratedBody::owned(std::span<const Index> nodes) const {
  std::vector<Index> here;
  std::ranges::copy_if(nodes, std::back_inserter(here),
                       [this](Index node) { return node >= body_.owned_begin && node < body_.owned_end; });
  return here;
}

void AcceleratedBody::start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) {
  FiniteElementBody::start(body, centre, state);
  is_loaded_ = false;
}

void AcceleratedBody::clear_force(std::span<NodeForce> force) const {
  for (const Index node : chosen_->nodes) {
    force[node] = {};
  }
}

void AcceleratedBody::add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const {
  FiniteElementBody::clear_force(force);  // clear_force() cleared the chosen nodes only
  FiniteElementBody::add_internal_force(state, force);
}

void AcceleratedBody::finish_internal_force(std::span<const NodeState> state, std::span<NodeForce> /*force*/) {
  if (is_loaded_) {
    there_->write(*ghosts_, state);
  } else {
    there_->load(state, solid_);
    is_loaded_ = true;
  }
  there_->find_stress();
}

void AcceleratedBody::advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                                         ReproducibleSum& work) {
  const solid::Kick kick = kick_of(step, mass_damping_, gravity_);
  there_->advance(kick, is_alone() ? Displacements::follow : Displacements::stay);
  there_->push(*chosen_, kick, force);
  if (!needs_velocities_) {
    return;
  }
  there_->read(*followed_, state);
  if (!steered_.empty()) {
    constraints_.steer(number_, step, mass_, state, work);
    there_->write(*followed_, state);
  }
}

void AcceleratedBody::advance_displacements(const Step& /*step*/, std::span<NodeState> state) {
  if (!is_alone()) {
    there_->displace();
    there_->read(*followed_, state);
  }
}

void AcceleratedBody::choose_nodes(std::span<const Index> nodes, int /*most_at_once*/) {
  std::vector<Index> chosen = owned(nodes);
  keep_each_once(chosen);
  if (chosen_ && chosen == chosen_->nodes) {
    return;
  }
  std::vector<Index> followed = chosen;
  followed.insert(followed.end(), exchanged_.begin(), exchanged_.end());
  keep_each_once(followed);
  chosen_.emplace(there_->list(std::move(chosen)));
  followed_.emplace(there_->list(std::move(followed)));
}

void AcceleratedBody::update_nodes(std::span<NodeState> state) {
  if (is_loaded_) {
    there_->save(state);
  }
}

void AcceleratedBody::update_all(std::span<NodeState> state) {
  if (is_loaded_) {
    there_->save(state);
    there_->save_memory(solid_);
  }
}

void AcceleratedBody::update_ghosts_on_accelerator(std::span<const NodeState> state) {
  there_->write(*ghosts_, state);
}

void AcceleratedBody::archive(parallel::Archive& archive) {
  if (is_loaded_ && !archive.restoring()) {
    there_->save_memory(solid_);
  }
  FiniteElementBody::archive(archive);
  is_loaded_ = is_loaded_ && !archive.restoring();
}

}  // namespace idiophone::motion
