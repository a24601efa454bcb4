#include "modal_body.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

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

Eigen::Matrix3d cross_matrix(const Vector3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
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
  masses_ = basis.masses;
  shapes_ = ModalShapes(basis);
  find_moments();
  all_ = NodeGroup(shapes_, arms_, numbers_below(masses_.size()));
  residual_ = ResidualFlexibility(basis, omitted_mobility());
  if (is_free_) {
    frame_ = FloatingFrame(mass_, moment_, basis.mass_damping, gravity_);
  }
}

void ModalBody::find_moments() {
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    mass_ += masses_[node];
    centre_ += masses_[node] * part_.reference[body_.owned_begin + node];
  }
  centre_ /= mass_;
  moments_.assign(modes_, {Vector3::Zero(), Vector3::Zero(), Eigen::Matrix3d::Zero()});
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    const Vector3 arm = arms_.emplace_back(part_.reference[body_.owned_begin + node] - centre_);
    moment_ += masses_[node] * arm * arm.transpose();
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      const Vector3 weighted = masses_[node] * shapes_.at(mode, node);
      moments_[mode].momentum += weighted;
      moments_[mode].angular += arm.cross(weighted);
      moments_[mode].cross += weighted * arm.transpose();
    }
  }
  changes_.resize(6, static_cast<Eigen::Index>(modes_));
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    const Eigen::Matrix3d change = moments_[mode].cross + moments_[mode].cross.transpose();
    changes_.col(static_cast<Eigen::Index>(mode)) << change(0, 0), change(1, 1), change(2, 2), change(1, 2),
        change(0, 2), change(0, 1);
  }
}

std::vector<Eigen::Matrix3d> ModalBody::mobilities() const {
  const Eigen::Matrix3d inertia = moment_.trace() * Eigen::Matrix3d::Identity() - moment_;
  const Eigen::Matrix3d inverse = inertia.inverse();
  std::vector<Eigen::Matrix3d> mobilities;
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    Eigen::Matrix3d& mobility = mobilities.emplace_back(Eigen::Matrix3d::Zero());
    if (is_free_) {
      const Eigen::Matrix3d arm = cross_matrix(arms_[node]);
      mobility = Eigen::Matrix3d::Identity() / mass_ + arm * inverse * arm.transpose();
    }
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      const Vector3 shape = shapes_.at(mode, node);
      mobility += shape * shape.transpose();
    }
  }
  return mobilities;
}

std::vector<double> ModalBody::omitted_mobility() const {
  std::vector<double> omitted;
  for (const Eigen::Matrix3d& kept : mobilities()) {
    omitted.push_back(std::max(0.0, 1 / masses_[omitted.size()] - kept.trace() / 3));
  }
  return omitted;
}

std::vector<double> ModalBody::inverse_masses() const {
  std::vector<double> inverse;
  for (const Eigen::Matrix3d& mobility : mobilities()) {
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
  residual_.choose(numbers_below(masses_.size()), step);
}

void ModalBody::start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) {
  if (!is_here()) {
    return;
  }
  // What the displacements of the start are as rigid motion, and the rest as modes: M makes them orthogonal.
  Vector3 shift = Vector3::Zero();
  Vector3 turned = Vector3::Zero();
  for (std::size_t node = 0; is_free_ && node < masses_.size(); ++node) {
    const Eigen::Map<const Vector3> displacement(state[body_.owned_begin + node].displacement);
    shift += masses_[node] / mass_ * displacement;
    turned += masses_[node] * (part_.reference[body_.owned_begin + node] - centre).cross(displacement);
  }
  const Eigen::Matrix3d inertia = moment_.trace() * Eigen::Matrix3d::Identity() - moment_;
  const Vector3 angle = is_free_ ? Vector3(inertia.inverse() * turned) : Vector3::Zero();
  const Eigen::AngleAxisd turn(angle.norm(), angle.isZero(0.0) ? Vector3::UnitX() : angle.normalized());
  if (is_free_) {
    frame_.start(shift, Eigen::Quaterniond(turn), body.velocity, body.spin);
  }
  Eigen::ArrayXd places = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(modes_));
  Eigen::ArrayXd rates = places;
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    const Vector3 arm = part_.reference[body_.owned_begin + node] - centre;
    const Eigen::Map<const Vector3> displacement(state[body_.owned_begin + node].displacement);
    const Vector3 deformed = frame_.turn().transpose() * (displacement - frame_.shift() - frame_.turn_less_one() * arm);
    const Vector3 velocity = is_free_ ? Vector3(Vector3::Zero()) : Vector3(body.velocity + body.spin.cross(arm));
    shapes_.add_products(node, masses_[node] * deformed, places);
    shapes_.add_products(node, masses_[node] * velocity, rates);
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
    load.torque += (arms_[number] + displacement - frame_.shift()).cross(here);
    shapes_.add_products(number, turned, load.modal);
  }
  add_inertia(load.modal);
}

/// Weight, which free bodies feel as a whole, and the centrifugal forces of those.
void ModalBody::add_inertia(Eigen::ArrayXd& modal) const {
  if (!is_free_) {
    for (std::size_t mode = 0; mode < modes_ && !gravity_.isZero(0.0); ++mode) {
      modal[static_cast<Eigen::Index>(mode)] += moments_[mode].momentum.dot(gravity_);
    }
    return;
  }
  const Vector3 spin = frame_.own_spin();
  if (spin.isZero(0.0)) {
    return;
  }
  // trace(cross) spin^2 - spin . cross spin
  Eigen::Vector<double, 6> weights;
  weights << (spin[1] * spin[1] + spin[2] * spin[2]) / 2, (spin[0] * spin[0] + spin[2] * spin[2]) / 2,
      (spin[0] * spin[0] + spin[1] * spin[1]) / 2, -spin[1] * spin[2], -spin[0] * spin[2], -spin[0] * spin[1];
  modal += (changes_.transpose() * weights).array();
}

Eigen::Matrix3d ModalBody::change_of_moment() const {
  const Eigen::Vector<double, 6> change = changes_ * coordinates_.places().matrix();
  Eigen::Matrix3d matrix;
  matrix << change[0], change[5], change[4], change[5], change[1], change[3], change[4], change[3], change[2];
  return matrix;
}

void ModalBody::advance(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                        ReproducibleSum& /*work*/) {
  if (!is_here() || step.number % steps_at_once_ != 0) {
    return;
  }
  Step own = step;
  own.length *= steps_at_once_;
  own.before = before_;
  find_load(force, state, load_);
  if (is_free_) {
    frame_.advance(own, load_.force, load_.torque, change_of_moment());
  }
  coordinates_.advance(own, load_.modal);
  for (std::size_t pack = 0; pack < chosen_.packs(); ++pack) {
    residual_.advance(pack, load_.at_nodes[pack], own);
  }
  before_ = own.length;
  update_chosen(state);
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
  std::ranges::sort(chosen);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  residual_.choose(chosen, steps_at_once_ * step_);
  if (chosen != chosen_.nodes()) {
    chosen_ = NodeGroup(shapes_, arms_, std::move(chosen));
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
  const FloatingFrame::Motion rigid = is_free_
                                          ? frame_.now(own, now.force, now.torque, change_of_moment())
                                          : FloatingFrame::Motion{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 displacement = mass_ * frame_.shift();
  Vector3 momentum = mass_ * rigid.velocity;
  Vector3 angular = mass_ * frame_.shift().cross(rigid.velocity) + rigid.angular_momentum;
  Eigen::Matrix3d deformed = Eigen::Matrix3d::Zero();  // sum m (R sum q phi) (X - C)^T
  const Eigen::ArrayXd& places = coordinates_.places();
  const Eigen::ArrayXd rates = coordinates_.rates_now(own, now.modal);
  for (std::size_t k = 0; k < modes_; ++k) {
    const auto mode = static_cast<Eigen::Index>(k);
    if (!is_free_) {
      displacement += places[mode] * moments_[k].momentum;
      momentum += rates[mode] * moments_[k].momentum;
      angular += rates[mode] * moments_[k].angular;
    }
    deformed += places[mode] * frame_.turn() * moments_[k].cross;
  }
  const double kinetic = mass_ / 2 * rigid.velocity.squaredNorm() + rigid.spin.dot(rigid.angular_momentum) / 2 +
                         rates.square().sum() / 2 + residual_.kinetic_energy();
  const double elastic = coordinates_.elastic_energy() + residual_.elastic_energy();
  const Eigen::Matrix3d turned = frame_.turn_less_one() * moment_;
  const Eigen::Matrix3d mixed = deformed * frame_.turn_less_one().transpose();
  const Vector3 shift = displacement / mass_;
  const double area = unit.length * unit.length * unit.mass;
  add(sums.displacement, displacement / (unit.mass * unit.length));
  add(sums.momentum, momentum / unit.mass);
  add(sums.angular_momentum, angular / (unit.mass * unit.length));
  add(sums.cross_moment, Eigen::Matrix3d((turned + deformed) / area));
  // Of second order in the vibration is left out.
  const Eigen::Matrix3d second =
      is_free_ ? Eigen::Matrix3d(mass_ * shift * shift.transpose() + turned * frame_.turn_less_one().transpose() +
                                 mixed + mixed.transpose())
               : Eigen::Matrix3d(mass_ * shift * shift.transpose());
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
      residual_.choose(numbers_below(masses_.size()), step_);
    }
    archive.rows(path + "/residual", rows_of(nodes_, masses_.size()),
                 [this](std::size_t node, parallel::ArchiveRow& row) { residual_.archive(node, row); });
  }
}

}  // namespace idiophone::motion
