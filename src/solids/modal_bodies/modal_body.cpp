#include "modal_body.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace idiophone::modal_bodies {

namespace {

std::vector<std::size_t> numbers_below(std::size_t end) {
  std::vector<std::size_t> numbers(end);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

ModalBody::ModalBody(std::string name, const Vector3& gravity, const mesh::Part& part, std::size_t number,
                     const ModalBasis& basis, std::shared_ptr<CommonModes> modes)
    : part_(part),
      body_(part.bodies[number]),
      name_(std::move(name)),
      gravity_(gravity),
      is_free_(basis.is_free),
      has_residual_(std::ranges::any_of(basis.residual, [](double flexibility) { return flexibility > 0; })),
      nodes_(basis.nodes()),
      modes_(basis.modes()),
      common_(std::move(modes)),
      highest_frequency_(basis.further == 0 ? residual_frequency(basis)
                                            : std::max(residual_frequency(basis), basis.frequencies.back())) {
  common_->bodies.push_back(this);
  if (body_.owned_begin == body_.owned_end) {
    return;
  }
  shapes_ = ModalShapes(basis);
  std::vector<Vector3> places(part_.reference.begin() + body_.owned_begin, part_.reference.begin() + body_.owned_end);
  for (std::size_t c = 0; c < basis.rest.size(); c += 3) {
    rest_.emplace_back(&basis.rest[c]);
  }
  for (std::size_t node = 0; node < rest_.size(); ++node) {
    places[node] += rest_[node];
    mean_rest_ += basis.masses[node] * rest_[node];
  }
  mean_rest_ /= std::accumulate(basis.masses.begin(), basis.masses.end(), 0.0);
  inertia_ = ModalInertia(basis.masses, places, shapes_);
  rest_moments_ = find_rest_moments();
  all_ = NodeGroup(shapes_, inertia_.arms(), numbers_below(inertia_.masses().size()));
  residual_ = ResidualFlexibility(basis, omitted_mobility());
  if (basis.common_with) {
    share_of_mass_ = shapes_.mass_products(inertia_.masses());
  }
  rest_force_ = Eigen::ArrayXd::Map(basis.rest_force.data(), std::ssize(basis.rest_force));
  rest_stiffness_ =
      Eigen::MatrixXd::Map(basis.rest_stiffness.data(), std::ssize(basis.rest_force), std::ssize(basis.rest_force));
  if (is_free_) {
    frame_ = FloatingFrame(inertia_.mass(), inertia_.second_moment(), basis.mass_damping, gravity_);
  }
}

std::vector<double> ModalBody::omitted_mobility() const {
  std::vector<double> omitted;
  for (const Eigen::Matrix3d& kept : inertia_.mobilities(shapes_, is_free_)) {
    omitted.push_back(std::max(0.0, 1 / inertia_.masses()[omitted.size()] - kept.trace() / 3));
  }
  return omitted;
}

std::vector<double> ModalBody::inverse_masses() const {
  std::vector<double> inverse;
  for (const Eigen::Matrix3d& mobility : inertia_.mobilities(shapes_, is_free_)) {
    const double kept = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mobility).eigenvalues().maxCoeff();
    inverse.push_back(kept + residual_.inverse_mass(inverse.size()));
  }
  return inverse;
}

double ModalBody::largest_eigenvalue(std::span<const double> springs) const {
  const std::span<const double> own = springs.subspan(body_.owned_begin, inertia_.masses().size());
  double of_residual = 0.0;  // each node has its own oscillators
  for (std::size_t node = 0; node < own.size(); ++node) {
    of_residual = std::max(of_residual, own[node] * residual_.inverse_mass(node));
  }
  return own.empty() ? 0.0 : inertia_.largest_eigenvalue(shapes_, is_free_, own) + of_residual;
}

motion::StableStep ModalBody::stable_step(const motion::Supports& supports, const motion::BodyRanks& /*ranks*/) const {
  motion::StableStep result;
  result.damping = largest_eigenvalue(supports.damping);
  // Supports of other bodies of common modes count as if each were as stiff as these.
  const auto bodies = static_cast<double>(common_->bodies.size());
  result.damping *= bodies;
  const double of_stress = rest_.empty() ? 0.0 : rest_stiffness_.cwiseAbs().rowwise().sum().maxCoeff();
  result.largest_frequency =
      std::sqrt(highest_frequency_ * highest_frequency_ + bodies * largest_eigenvalue(supports.stiffness) + of_stress);
  result.step = motion::largest_step(result.largest_frequency, result.damping);
  return result;
}

void ModalBody::begin(double step) {
  step_ = step;
  residual_.choose(numbers_below(inertia_.masses().size()), step);
}

void ModalBody::start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) {
  if (!is_here()) {
    return;
  }
  const auto arm_of = [&](std::size_t node) -> Vector3 {
    return part_.reference[body_.owned_begin + node] + rest_at(node) - (centre + mean_rest_);
  };
  // What the displacements of the start are as rigid motion, and the rest as modes: M makes them orthogonal.
  Vector3 shift = Vector3::Zero();
  Vector3 turned = Vector3::Zero();
  for (std::size_t node = 0; is_free_ && node < inertia_.masses().size(); ++node) {
    const Vector3 displacement = Vector3(state[body_.owned_begin + node].displacement) - rest_at(node);
    shift += inertia_.masses()[node] / inertia_.mass() * displacement;
    turned += inertia_.masses()[node] * arm_of(node).cross(displacement);
  }
  const Vector3 angle = is_free_ ? Vector3(inertia_.inverse_inertia() * turned) : Vector3::Zero();
  const Eigen::AngleAxisd turn(angle.norm(), angle.isZero(0.0) ? Vector3::UnitX() : angle.normalized());
  if (is_free_) {
    frame_.start(shift, Eigen::Quaterniond(turn), body.velocity, body.spin);
  }
  // Those of the bodies before it, if it has common modes with them.
  Eigen::ArrayXd places = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(modes_));
  Eigen::ArrayXd rates = places;
  if (!is_first()) {
    places = coordinates().places();
    rates = coordinates().rates();
  }
  for (std::size_t node = 0; node < inertia_.masses().size(); ++node) {
    const Vector3 arm = arm_of(node);
    const Vector3 displacement = Vector3(state[body_.owned_begin + node].displacement) - rest_at(node);
    const Vector3 deformed = frame_.turn().transpose() * (displacement - frame_.shift() - frame_.turn_less_one() * arm);
    const Vector3 velocity = is_free_ ? Vector3(Vector3::Zero()) : Vector3(body.velocity + body.spin.cross(arm));
    shapes_.add_products(node, inertia_.masses()[node] * deformed, places);
    shapes_.add_products(node, inertia_.masses()[node] * velocity, rates);
  }
  coordinates().start(places, rates);
}

void ModalBody::clear_force(std::span<NodeForce> force) const {
  for (const std::size_t node : chosen_.nodes()) {
    force[body_.owned_begin + node] = NodeForce{};
  }
}

void ModalBody::find_load(std::span<const NodeForce> force, std::span<const NodeState> state, Load& load) const {
  load.modal.setZero(static_cast<Eigen::Index>(modes_));
  load.force = load.torque = Vector3::Zero();
  load.at_nodes.assign(chosen_.packs(), PackVector{});
  const Eigen::Matrix3d back = frame_.turn().transpose();
  for (std::size_t i = 0; i < chosen_.nodes().size(); ++i) {
    const std::size_t number = chosen_.nodes()[i];
    const std::size_t node = body_.owned_begin + number;
    const Vector3 here(force[node].component);
    if (here.isZero(0.0)) {
      continue;
    }
    const Vector3 turned = back * here;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      load.at_nodes[i / solid::lanes].at(axis)[i % solid::lanes] = turned[static_cast<Eigen::Index>(axis)];
    }
    const Vector3 displacement = Vector3(state[node].displacement) - rest_at(number);
    load.force += here;
    load.torque += (inertia_.arms()[number] + displacement - frame_.shift()).cross(here);
    shapes_.add_products(number, turned, load.modal);
  }
  if (is_free_) {
    inertia_.add_centrifugal(frame_.own_spin(), load.modal);
  } else {
    inertia_.add_weight(gravity_, load.modal);
  }
  if (!rest_.empty()) {
    load.modal += rest_force_;
    load.modal.matrix().noalias() -= rest_stiffness_ * coordinates().places().matrix();
  }
}

void ModalBody::add_loads_of_others(std::span<const NodeForce> force, std::span<const NodeState> state,
                                    Eigen::ArrayXd& modal) const {
  for (const ModalBody* body : common_->bodies) {
    if (body != this) {
      Load load;
      body->find_load(force, state, load);
      modal += load.modal;
    }
  }
}

void ModalBody::advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                                   ReproducibleSum& /*work*/) {
  if (!moves_in(step)) {
    return;
  }
  Step own = step;
  own.length *= steps_at_once_;
  own.before = before_;
  find_load(force, state, load_);
  if (is_free_) {
    frame_.advance(own, load_.force, load_.torque, inertia_.change_of_moment(coordinates().places()));
  }
  if (is_first()) {
    add_loads_of_others(force, state, load_.modal);
    coordinates().advance(own, load_.modal);
  }
  for (std::size_t pack = 0; pack < chosen_.packs(); ++pack) {
    residual_.advance(pack, load_.at_nodes[pack], own);
  }
  before_ = own.length;
}

void ModalBody::advance_displacements(const Step& step, std::span<NodeState> state) {
  if (moves_in(step)) {
    update_chosen(state);
  }
}

std::optional<motion::ModalState> ModalBody::modal_state() const {
  if (!is_here()) {
    return std::nullopt;
  }
  return motion::ModalState{.shift = frame_.shift(),
                            .turn_less_one = frame_.turn_less_one(),
                            .velocity = frame_.velocity(),
                            .spin = frame_.spin(),
                            .places = {coordinates().places().data(), modes_},
                            .rates = {coordinates().rates().data(), modes_}};
}

void ModalBody::archive(parallel::Archive& archive) {
  const auto rows_of = [&](std::size_t count, std::size_t here) {
    std::vector<Index> numbers(here);
    std::iota(numbers.begin(), numbers.end(), 0);
    return parallel::Rows(numbers, static_cast<std::int64_t>(count), archive.communicator());
  };
  const std::string path = "motion/modal/" + name_;
  const bool here = is_here();
  if (modes_ > 0) {
    archive.rows(path + "/modes", rows_of(modes_, here ? modes_ : 0),
                 [this](std::size_t mode, parallel::ArchiveRow& row) { coordinates().archive(mode, row); });
  }
  archive.rows(path + "/frame", rows_of(1, here ? 1 : 0), [this](std::size_t, parallel::ArchiveRow& row) {
    frame_.archive(row);
    row.value(before_);
    coordinates().archive_stored_energy(row);
  });
  coordinates().restored(before_);
  if (has_residual_) {
    if (archive.restoring()) {
      residual_.choose(numbers_below(inertia_.masses().size()), step_);
    }
    archive.rows(path + "/residual", rows_of(nodes_, inertia_.masses().size()),
                 [this](std::size_t node, parallel::ArchiveRow& row) { residual_.archive(node, row); });
  }
}

}  // namespace idiophone::modal_bodies
