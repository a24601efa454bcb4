#include "modal_body.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "idiophone/each_once.hpp"

namespace idiophone::motion {

namespace {

/// Component `i` of a 3 x 3 matrix times eight vectors.
Pack row_times(const Eigen::Matrix3d& matrix, Eigen::Index i, const PackVector& vectors) {
  return matrix(i, 0) * vectors[0] + matrix(i, 1) * vectors[1] + matrix(i, 2) * vectors[2];
}

PackVector times(const Eigen::Matrix3d& matrix, const PackVector& vectors) {
  return {row_times(matrix, 0, vectors), row_times(matrix, 1, vectors), row_times(matrix, 2, vectors)};
}

PackVector plus(const PackVector& a, const PackVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Displacements of eight nodes.
/// @param vibration  displacements in the frame, m
PackVector displaced(const FloatingFrame& frame, const PackVector& arms, const PackVector& vibration) {
  PackVector result = plus(times(frame.turn_less_one(), plus(arms, vibration)), vibration);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.at(axis) += frame.shift()[static_cast<Eigen::Index>(axis)];
  }
  return result;
}

std::vector<std::size_t> numbers_below(std::size_t end) {
  std::vector<std::size_t> numbers(end);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

ModalBody::ModalBody(const scene::Scene& scene, const mesh::Part& part, std::size_t number, const ModalBasis& basis)
    : part_(part),
      body_(part.bodies[number]),
      name_(scene.bodies[number].name),
      gravity_(scene.gravity),
      is_free_(basis.is_free),
      has_residual_(std::ranges::any_of(basis.residual, [](double flexibility) { return flexibility > 0; })),
      nodes_(basis.nodes()),
      modes_(basis.modes()),
      coordinates_(basis),
      highest_frequency_(residual_frequency(basis)) {
  if (body_.owned_begin == body_.owned_end) {
    return;
  }
  shapes_ = ModalShapes(basis);
  inertia_ = ModalInertia(basis.masses, std::span(part_.reference).subspan(body_.owned_begin), shapes_);
  all_ = NodeGroup(shapes_, inertia_.arms(), numbers_below(inertia_.masses().size()));
  residual_ = ResidualFlexibility(basis, omitted_mobility());
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

StableStep ModalBody::stable_step(const Supports& supports) const {
  const std::vector<double> inverse = inverse_masses();
  double square = highest_frequency_ * highest_frequency_;
  StableStep result;
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    const std::size_t node = body_.owned_begin + i;
    square += supports.stiffness[node] * inverse[i];
    result.damping += supports.damping[node] * inverse[i];
  }
  result.largest_frequency = std::sqrt(square);
  result.step = largest_step(result.largest_frequency, result.damping);
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
  // What the displacements of the start are as rigid motion, and the rest as modes: M makes them orthogonal.
  Vector3 shift = Vector3::Zero();
  Vector3 turned = Vector3::Zero();
  for (std::size_t node = 0; is_free_ && node < inertia_.masses().size(); ++node) {
    const Eigen::Map<const Vector3> displacement(state[body_.owned_begin + node].displacement);
    shift += inertia_.masses()[node] / inertia_.mass() * displacement;
    turned += inertia_.masses()[node] * (part_.reference[body_.owned_begin + node] - centre).cross(displacement);
  }
  const Vector3 angle = is_free_ ? Vector3(inertia_.inverse_inertia() * turned) : Vector3::Zero();
  const Eigen::AngleAxisd turn(angle.norm(), angle.isZero(0.0) ? Vector3::UnitX() : angle.normalized());
  if (is_free_) {
    frame_.start(shift, Eigen::Quaterniond(turn), body.velocity, body.spin);
  }
  Eigen::ArrayXd places = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(modes_));
  Eigen::ArrayXd rates = places;
  for (std::size_t node = 0; node < inertia_.masses().size(); ++node) {
    const Vector3 arm = part_.reference[body_.owned_begin + node] - centre;
    const Eigen::Map<const Vector3> displacement(state[body_.owned_begin + node].displacement);
    const Vector3 deformed = frame_.turn().transpose() * (displacement - frame_.shift() - frame_.turn_less_one() * arm);
    const Vector3 velocity = is_free_ ? Vector3(Vector3::Zero()) : Vector3(body.velocity + body.spin.cross(arm));
    shapes_.add_products(node, inertia_.masses()[node] * deformed, places);
    shapes_.add_products(node, inertia_.masses()[node] * velocity, rates);
  }
  coordinates_.start(places, rates);
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
    const Eigen::Map<const Vector3> displacement(state[node].displacement);
    load.force += here;
    load.torque += (inertia_.arms()[number] + displacement - frame_.shift()).cross(here);
    shapes_.add_products(number, turned, load.modal);
  }
  if (is_free_) {
    inertia_.add_centrifugal(frame_.own_spin(), load.modal);
  } else {
    inertia_.add_weight(gravity_, load.modal);
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
    frame_.advance(own, load_.force, load_.torque, inertia_.change_of_moment(coordinates_.places()));
  }
  coordinates_.advance(own, load_.modal);
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

int ModalBody::resolved(int most_at_once) const {
  constexpr double most = 2.5;
  int steps = most_at_once;
  while (steps > 1 && (most_at_once % steps != 0 || steps * step_ * highest_frequency_ > most)) {
    --steps;
  }
  return steps;
}

void ModalBody::choose_nodes(std::span<const Index> nodes, int most_at_once) {
  steps_at_once_ = resolved(most_at_once);
  std::vector<std::size_t> chosen;
  for (const Index node : nodes) {
    if (node >= body_.owned_begin && node < body_.owned_end) {
      chosen.push_back(node - body_.owned_begin);
    }
  }
  keep_each_once(chosen);
  residual_.choose(chosen, steps_at_once_ * step_);
  if (chosen != chosen_.nodes()) {
    chosen_ = NodeGroup(shapes_, inertia_.arms(), std::move(chosen));
  }
}

void ModalBody::update_nodes(std::span<NodeState> state) {
  for (std::size_t pack = 0; pack < all_.packs(); ++pack) {
    move(all_, pack, all_.vibration(pack, coordinates_.places(), coordinates_.rates()), state);
  }
  update_chosen(state);
}

void ModalBody::update_chosen(std::span<NodeState> state) const {
  for (std::size_t pack = 0; pack < chosen_.packs(); ++pack) {
    NodeGroup::Vibration vibration = chosen_.vibration(pack, coordinates_.places(), coordinates_.rates());
    residual_.add(pack, vibration);
    move(chosen_, pack, vibration, state);
  }
}

std::optional<ModalState> ModalBody::modal_state() const {
  if (!is_here()) {
    return std::nullopt;
  }
  return ModalState{.shift = frame_.shift(),
                    .turn_less_one = frame_.turn_less_one(),
                    .velocity = frame_.velocity(),
                    .spin = frame_.spin(),
                    .places = {coordinates_.places().data(), modes_},
                    .rates = {coordinates_.rates().data(), modes_}};
}

void ModalBody::move(const NodeGroup& group, std::size_t pack, const NodeGroup::Vibration& vibration,
                     std::span<NodeState> state) const {
  const PackVector displacement = displaced(frame_, group.arms(pack), vibration.displacement);
  const PackVector carried =
      times(cross_matrix(frame_.spin()) * frame_.turn(), plus(group.arms(pack), vibration.displacement));
  const PackVector vibrating = times(frame_.turn(), vibration.velocity);
  Pack lines[solid::lanes] = {};  // of NodeState
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lines[axis] = displacement.at(axis);
    lines[3 + axis] = frame_.velocity()[static_cast<Eigen::Index>(axis)] + (carried.at(axis) + vibrating.at(axis));
  }
  solid::transpose(lines);
  for (std::size_t lane = 0; lane < group.nodes(pack).size(); ++lane) {
    state[body_.owned_begin + group.nodes(pack)[lane]] = std::bit_cast<NodeState>(lines[lane]);
  }
}

void ModalBody::add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                         const Vector3& /*centre*/, const BodyUnits& unit, BodySums& sums) const {
  if (!is_here()) {
    return;
  }
  Load now;
  find_load(force, state, now);
  Step own = step;  // as if the next one were as long as the last
  own.length = own.before = before_;
  const FloatingFrame::Motion rigid =
      is_free_ ? frame_.now(own, now.force, now.torque, inertia_.change_of_moment(coordinates_.places()))
               : FloatingFrame::Motion{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 displacement = inertia_.mass() * frame_.shift();
  Vector3 momentum = inertia_.mass() * rigid.velocity;
  Vector3 angular = inertia_.mass() * frame_.shift().cross(rigid.velocity) + rigid.angular_momentum;
  Eigen::Matrix3d deformed = Eigen::Matrix3d::Zero();  // sum m (R sum q phi) (X - C)^T
  const Eigen::ArrayXd& places = coordinates_.places();
  const Eigen::ArrayXd rates = coordinates_.rates_now(own, now.modal);
  for (std::size_t k = 0; k < modes_; ++k) {
    const auto mode = static_cast<Eigen::Index>(k);
    if (!is_free_) {
      displacement += places[mode] * inertia_.moments(k).momentum;
      momentum += rates[mode] * inertia_.moments(k).momentum;
      angular += rates[mode] * inertia_.moments(k).angular;
    }
    deformed += places[mode] * frame_.turn() * inertia_.moments(k).cross;
  }
  const double kinetic = inertia_.mass() / 2 * rigid.velocity.squaredNorm() +
                         rigid.spin.dot(rigid.angular_momentum) / 2 + rates.square().sum() / 2 +
                         residual_.kinetic_energy();
  const double elastic = coordinates_.elastic_energy() + residual_.elastic_energy();
  const Eigen::Matrix3d turned = frame_.turn_less_one() * inertia_.second_moment();
  const Eigen::Matrix3d mixed = deformed * frame_.turn_less_one().transpose();
  const Vector3 shift = displacement / inertia_.mass();
  const double area = unit.length * unit.length * unit.mass;
  add(sums.displacement, displacement / (unit.mass * unit.length));
  add(sums.momentum, momentum / unit.mass);
  add(sums.angular_momentum, angular / (unit.mass * unit.length));
  add(sums.cross_moment, Eigen::Matrix3d((turned + deformed) / area));
  // Of second order in the vibration is left out.
  const Eigen::Matrix3d second =
      is_free_ ? Eigen::Matrix3d(inertia_.mass() * shift * shift.transpose() +
                                 turned * frame_.turn_less_one().transpose() + mixed + mixed.transpose())
               : Eigen::Matrix3d(inertia_.mass() * shift * shift.transpose());
  add(sums.second_moment, Eigen::Matrix3d(second / area));
  sums.kinetic.add(kinetic / unit.mass);
  sums.elastic.add(elastic / unit.mass);
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
                 [this](std::size_t mode, parallel::ArchiveRow& row) { coordinates_.archive(mode, row); });
  }
  archive.rows(path + "/frame", rows_of(1, here ? 1 : 0), [this](std::size_t, parallel::ArchiveRow& row) {
    frame_.archive(row);
    row.value(before_);
  });
  coordinates_.prepare(before_);
  if (has_residual_) {
    if (archive.restoring()) {
      residual_.choose(numbers_below(inertia_.masses().size()), step_);
    }
    archive.rows(path + "/residual", rows_of(nodes_, inertia_.masses().size()),
                 [this](std::size_t node, parallel::ArchiveRow& row) { residual_.archive(node, row); });
  }
}

}  // namespace idiophone::motion
