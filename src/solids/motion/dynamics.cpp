#include "idiophone/solids/motion/dynamics.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "accelerated_body.hpp"
#include "finite_element_body.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/motion/initial_state.hpp"

namespace idiophone::motion {

namespace {

std::vector<joints::MeshedJoint> acting(const scene::Solids& solids, const std::vector<joints::MeshedJoint>& joints) {
  std::vector<joints::MeshedJoint> found;
  std::ranges::copy_if(joints, std::back_inserter(found), [&](const joints::MeshedJoint& joint) {
    return !scene::has_common_modes(solids, solids.joints[joint.joint].surfaces[0].body);
  });
  return found;
}

}  // namespace

Dynamics::Dynamics(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments)
    : part_(part),
      loads_(solids, part, attachments),
      constraints_(solids, part, attachments),
      joints_(attachments.joints, part),
      acting_joints_(acting(solids, attachments.joints), part) {}

Dynamics::Dynamics(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
                   const ModelMaker& models, accelerator::Accelerator* accelerator)
    : Dynamics(solids, part, attachments) {
  accelerator_ = accelerator;
  std::vector<double> lumped(part.node_ids.size());
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    if (auto model = models(part, b)) {
      bodies_.push_back(std::move(model));
    } else {
      add_finite_elements(solids, MassScaling::as_in_scene, lumped);
    }
    if (const auto& faces = attachments.bodies[b].fracture; !faces.empty()) {
      fractures_.emplace_back(solids, b, faces, part, bodies_[b]->masses(), constraints_.held_components(b));
    }
  }
}

Dynamics::~Dynamics() = default;

const FiniteElementBody& Dynamics::add_finite_elements(const scene::Solids& solids, MassScaling scaling,
                                                       std::span<double> lumped) {
  const std::size_t number = bodies_.size();
  std::unique_ptr<FiniteElementBody> body;
  if (accelerator_ == nullptr) {
    body = std::make_unique<FiniteElementBody>(solids, part_, constraints_, number, scaling, lumped);
  } else {
    body = std::make_unique<AcceleratedBody>(*accelerator_, solids, part_, constraints_, number, scaling, lumped);
  }
  const FiniteElementBody& added = *body;
  bodies_.push_back(std::move(body));
  return added;
}

FiniteElementDynamics::FiniteElementDynamics(const scene::Solids& solids, const mesh::Part& part,
                                             const Attachments& attachments, MassScaling scaling)
    : Dynamics(solids, part, attachments) {
  std::vector<double> lumped(part.node_ids.size());
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    finite_elements_.push_back(&add_finite_elements(solids, scaling, lumped));
  }
}

const solid::Mass& FiniteElementDynamics::mass(std::size_t body) const {
  return finite_elements_[body]->mass();
}

const solid::Solid& FiniteElementDynamics::solid(std::size_t body) const {
  return finite_elements_[body]->solid();
}

double FiniteElementDynamics::predicted_shift(std::size_t body) const {
  return finite_elements_[body]->predicted_shift();
}

void Dynamics::begin(double step) {
  loads_.begin(step);
  for (const auto& body : bodies_) {
    body->begin(step);
  }
}

void Dynamics::start(std::span<const scene::Body> bodies, const std::vector<Vector3>& centres,
                     std::span<NodeState> state) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b]->start(bodies[b], centres[b], state);
  }
  constraints_.place(0.0, state);
}

void Dynamics::clear(std::span<NodeForce> force) const {
  for (const auto& body : bodies_) {
    body->clear_force(force);
  }
  std::ranges::fill(force.subspan(part_.owned_nodes), NodeForce{});
}

void Dynamics::compute_force(double time, std::span<const NodeState> state, std::span<NodeForce> force) const {
  clear(force);
  for (const auto& body : bodies_) {
    body->add_internal_force(state, force);
  }
  add_outer_forces(time, state, force);
}

void Dynamics::add_outer_forces(double time, std::span<const NodeState> state, std::span<NodeForce> force) const {
  loads_.add(time, state, force);
  acting_joints_.add_force(state, force);
}

void Dynamics::hide_exchange() {
  for (const auto& body : bodies_) {
    body->hide_exchange();
  }
}

void Dynamics::begin_force(std::span<const NodeState> state, std::span<NodeForce> force) {
  clear(force);
  for (const auto& body : bodies_) {
    body->begin_internal_force(state, force);
  }
}

void Dynamics::finish_force(double time, std::span<const NodeState> state, std::span<NodeForce> force) {
  for (const auto& body : bodies_) {
    body->finish_internal_force(state, force);
  }
  add_outer_forces(time, state, force);
  loads_.remember(time, state);
}

void Dynamics::advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                                  ReproducibleSum& work) {
  for (const auto& body : bodies_) {
    body->advance_velocities(step, force, state, work);
  }
  for (BodyFracture& fracture : fractures_) {
    fracture.join(step, state);
  }
}

void Dynamics::advance_displacements(const Step& step, std::span<NodeState> state, ReproducibleSum& work) {
  for (const auto& body : bodies_) {
    body->advance_displacements(step, state);
  }
  loads_.add_work(step, state, work);
}

void Dynamics::add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                        const InitialState& initial_state, std::span<BodySums> sums) const {
  for (const BodyFracture& fracture : fractures_) {
    fracture.share(force);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::span<BodySums> whole = sums.subspan(b, 1);
    const std::span<BodySums> pieces = sums.subspan(bodies_.size() + part_.first_piece[b], part_.piece_count(b));
    bodies_[b]->add_sums(step, force, state, initial_state.centres[b], BodyUnits(initial_state, b),
                         pieces.empty() ? whole : pieces);
    for (const BodySums& piece : pieces) {
      whole.front().merge(piece);
    }
  }
}

void Dynamics::balance_loads(const InitialState& initial_state) {
  std::vector<std::span<const double>> masses;
  for (const auto& body : bodies_) {
    masses.push_back(body->masses());
  }
  loads_.balance(part_, initial_state, masses);
}

void Dynamics::choose_nodes(std::vector<Index> nodes, const Period& period, int most_at_once) {
  std::vector<int> at_once;
  const std::vector<Index> joined = joints_.nodes();
  nodes.insert(nodes.end(), joined.begin(), joined.end());
  const std::vector<Index> pulsed = loads_.pulsed_nodes(period.begin, period.end);
  for (const mesh::BodyPart& body : part_.bodies) {
    const auto is_own = [&](Index node) { return node >= body.owned_begin && node < body.owned_end; };
    const bool acted_on = std::ranges::any_of(nodes, is_own) || std::ranges::any_of(pulsed, is_own);
    at_once.push_back(acted_on ? 1 : most_at_once);
  }
  const std::vector<Index> loaded = loads_.nodes(period.begin);
  nodes.insert(nodes.end(), pulsed.begin(), pulsed.end());
  nodes.insert(nodes.end(), loaded.begin(), loaded.end());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b]->choose_nodes(nodes, at_once[b]);
  }
}

int Dynamics::steps_at_once() const {
  int steps = std::numeric_limits<int>::max();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (part_.bodies[b].owned_begin < part_.bodies[b].owned_end) {
      steps = std::min(steps, bodies_[b]->steps_at_once());
    }
  }
  return steps;
}

void Dynamics::update_nodes(std::span<NodeState> state) {
  for (const auto& body : bodies_) {
    body->update_nodes(state);
  }
}

void Dynamics::update_ghosts_on_accelerator(std::span<const NodeState> state) {
  for (const auto& body : bodies_) {
    body->update_ghosts_on_accelerator(state);
  }
}

void Dynamics::update_all(std::span<NodeState> state) {
  for (const auto& body : bodies_) {
    body->update_all(state);
  }
}

void Dynamics::archive(parallel::Archive& archive) {
  loads_.archive(archive);
  for (const auto& body : bodies_) {
    body->archive(archive);
  }
  for (BodyFracture& fracture : fractures_) {
    fracture.archive(archive);
  }
}

}  // namespace idiophone::motion
