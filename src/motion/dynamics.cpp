#include "idiophone/motion/dynamics.hpp"

#include <algorithm>

#include "finite_element_body.hpp"
#include "modal_body.hpp"

namespace idiophone::motion {

Dynamics::Dynamics(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments,
                   std::span<const ModalBasis> bases)
    : part_(part), loads_(scene, part, attachments), constraints_(scene, part, attachments) {
  std::vector<double> lumped(part.node_ids.size());
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    if (!bases.empty() && !bases[b].empty()) {
      bodies_.push_back(std::make_unique<ModalBody>(scene, part, b, bases[b]));
      finite_elements_.push_back(nullptr);
      continue;
    }
    auto body = std::make_unique<FiniteElementBody>(scene, part, constraints_, b, lumped);
    finite_elements_.push_back(body.get());
    bodies_.push_back(std::move(body));
  }
}

Dynamics::~Dynamics() = default;

const solid::Mass& Dynamics::mass(std::size_t body) const {
  return finite_elements_[body]->mass();
}

const solid::Solid& Dynamics::solid(std::size_t body) const {
  return finite_elements_[body]->solid();
}

double Dynamics::predicted_shift(std::size_t body) const {
  return finite_elements_[body]->predicted_shift();
}

void Dynamics::begin(double step) {
  for (const auto& body : bodies_) {
    body->begin(step);
  }
}

void Dynamics::start(const scene::Scene& scene, const std::vector<Vector3>& centres, std::span<NodeState> state) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b]->start(scene.bodies[b], centres[b], state);
  }
  constraints_.place(0.0, state);
}

void Dynamics::compute_force(double time, std::span<const NodeState> state, std::span<NodeForce> force) const {
  std::ranges::fill(force, NodeForce{});
  for (const auto& body : bodies_) {
    body->add_internal_force(state, force);
  }
  loads_.add(time, state, force);
}

void Dynamics::compute_force_and_remember(double time, std::span<const NodeState> state, std::span<NodeForce> force) {
  std::ranges::fill(force, NodeForce{});
  for (const auto& body : bodies_) {
    body->add_internal_force_and_remember(state, force);
  }
  loads_.add(time, state, force);
}

void Dynamics::advance(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                       ReproducibleSum& work) {
  for (const auto& body : bodies_) {
    body->advance(step, force, state, work);
  }
  loads_.add_work(step, state, work);
}

void Dynamics::add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                        const InitialState& initial_state, std::span<BodySums> sums) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b]->add_sums(step, force, state, initial_state.centres[b], BodyUnits(initial_state, b), sums[b]);
  }
}

void Dynamics::balance_loads(const InitialState& initial_state) {
  std::vector<std::span<const double>> masses;
  for (const auto& body : bodies_) {
    masses.push_back(body->masses());
  }
  loads_.balance(part_, initial_state, masses);
}

void Dynamics::choose_nodes(double time, std::vector<Index> nodes) {
  const std::vector<Index> loaded = loads_.nodes(time);
  nodes.insert(nodes.end(), loaded.begin(), loaded.end());
  for (const auto& body : bodies_) {
    body->choose_nodes(nodes);
  }
}

void Dynamics::update_nodes(std::span<NodeState> state) {
  for (const auto& body : bodies_) {
    body->update_nodes(state);
  }
}

void Dynamics::update_surface(std::span<NodeState> state) {
  for (const auto& body : bodies_) {
    body->update_surface(state);
  }
}

void Dynamics::archive(parallel::Archive& archive) {
  for (const auto& body : bodies_) {
    body->archive(archive);
  }
}

}  // namespace idiophone::motion
