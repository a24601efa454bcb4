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

Vector3 lane_of(const PackVector& vectors, std::size_t lane) {
  return {vectors[0][lane], vectors[1][lane], vectors[2][lane]};
}

double sum(const Pack& pack) {
  double total = 0.0;
  for (int lane = 0; lane < solid::lanes; ++lane) {
    total += pack[lane];
  }
  return total;
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
      places_(basis.modes()),
      rates_(basis.modes()),
      thickness_(basis.thickness) {
  for (std::size_t mode = 0; mode < basis.modes(); ++mode) {
    modes_.push_back({basis.frequencies[mode], basis.decay_rates[mode], {}});
  }
  if (body_.owned_begin == body_.owned_end) {
    return;
  }
  masses_ = basis.masses;
  shapes_ = ModalShapes(basis);
  find_moments();
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
  arms_.resize(shapes_.packs());
  moments_.assign(modes_.size(), {Vector3::Zero(), Vector3::Zero(), Eigen::Matrix3d::Zero()});
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    const Vector3 arm = part_.reference[body_.owned_begin + node] - centre_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arms_[node / solid::lanes].at(axis)[node % solid::lanes] = arm[static_cast<Eigen::Index>(axis)];
    }
    moment_ += masses_[node] * arm * arm.transpose();
    for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
      const Vector3 weighted = masses_[node] * shapes_.at(mode, node);
      moments_[mode].momentum += weighted;
      moments_[mode].angular += arm.cross(weighted);
      moments_[mode].cross += weighted * arm.transpose();
    }
  }
}

std::vector<Eigen::Matrix3d> ModalBody::mobilities() const {
  const Eigen::Matrix3d inertia = moment_.trace() * Eigen::Matrix3d::Identity() - moment_;
  const Eigen::Matrix3d inverse = inertia.inverse();
  std::vector<Eigen::Matrix3d> mobilities;
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    Eigen::Matrix3d& mobility = mobilities.emplace_back(Eigen::Matrix3d::Zero());
    if (is_free_) {
      const Eigen::Matrix3d arm = cross_matrix(lane_of(arms_[node / solid::lanes], node % solid::lanes));
      mobility = Eigen::Matrix3d::Identity() / mass_ + arm * inverse * arm.transpose();
    }
    for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
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

void ModalBody::begin(double step) {
  for (Mode& mode : modes_) {
    mode.step = OscillatorStep(mode.frequency, mode.decay, step);
  }
  residual_.begin(step);
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
  std::ranges::fill(places_, 0.0);
  std::ranges::fill(rates_, 0.0);
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    const Vector3 arm = part_.reference[body_.owned_begin + node] - centre;
    const Eigen::Map<const Vector3> displacement(state[body_.owned_begin + node].displacement);
    const Vector3 deformed = frame_.turn().transpose() * (displacement - frame_.shift() - frame_.turn_less_one() * arm);
    const Vector3 velocity = is_free_ ? Vector3(Vector3::Zero()) : Vector3(body.velocity + body.spin.cross(arm));
    for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
      const Vector3 weighted = masses_[node] * shapes_.at(mode, node);
      places_[mode] += weighted.dot(deformed);
      rates_[mode] += weighted.dot(velocity);
    }
  }
}

ModalBody::Load ModalBody::load(std::span<const NodeForce> force, std::span<const NodeState> state) const {
  Load load;
  load.modal.resize(modes_.size());
  load.at_nodes.reserve(chosen_.size());
  std::vector<Pack> sums(modes_.size());
  for (const std::size_t pack : chosen_) {
    PackVector forces = {};
    bool any = false;
    for (std::size_t lane = 0; lane < solid::lanes && solid::lanes * pack + lane < masses_.size(); ++lane) {
      const std::size_t node = body_.owned_begin + solid::lanes * pack + lane;
      const Vector3 here(force[node].component);
      if (here.isZero(0.0)) {
        continue;
      }
      any = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        forces.at(axis)[lane] = force[node].component[axis];
      }
      const Eigen::Map<const Vector3> displacement(state[node].displacement);
      load.force += here;
      load.torque += (part_.reference[node] + displacement - centre_ - frame_.shift()).cross(here);
    }
    load.at_nodes.push_back(any ? times(frame_.turn().transpose(), forces) : forces);
    if (any) {
      shapes_.add_products(pack, load.at_nodes.back(), sums);
    }
  }
  std::ranges::transform(sums, load.modal.begin(), sum);
  add_inertia(load.modal);
  return load;
}

/// Weight, which free bodies feel as a whole, and the centrifugal forces of those.
void ModalBody::add_inertia(std::span<double> modal) const {
  const Vector3 spin = frame_.own_spin();
  if (!is_free_ ? gravity_.isZero(0.0) : spin.isZero(0.0)) {
    return;
  }
  for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
    const Eigen::Matrix3d& cross = moments_[mode].cross;
    modal[mode] +=
        is_free_ ? cross.trace() * spin.squaredNorm() - spin.dot(cross * spin) : moments_[mode].momentum.dot(gravity_);
  }
}

Eigen::Matrix3d ModalBody::change_of_moment() const {
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  for (std::size_t mode = 0; mode < modes_.size(); ++mode) {
    cross += places_[mode] * moments_[mode].cross;
  }
  return cross + cross.transpose();
}

void ModalBody::advance(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                        ReproducibleSum& /*work*/) {
  if (!is_here()) {
    return;
  }
  const Load now = load(force, state);
  if (is_free_) {
    frame_.advance(step, now.force, now.torque, change_of_moment());
  }
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Mode& mode = modes_[k];
    const double target = now.modal[k] / (mode.frequency * mode.frequency);
    rates_[k] = step.is_first() ? first_rate(mode.frequency, mode.decay, step.length, places_[k], rates_[k], target)
                                : mode.step.keep * rates_[k] + mode.step.pull * (target - places_[k]);
    places_[k] += step.length * rates_[k];
  }
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    residual_.advance(chosen_[i], now.at_nodes[i], step.length);
    (void)update_pack(chosen_[i], state);
  }
}

void ModalBody::choose_nodes(std::span<const Index> nodes) {
  chosen_.clear();
  for (const Index node : nodes) {
    if (node >= body_.owned_begin && node < body_.owned_end) {
      chosen_.push_back((node - body_.owned_begin) / solid::lanes);
    }
  }
  std::ranges::sort(chosen_);
  const auto repeated = std::ranges::unique(chosen_);
  chosen_.erase(repeated.begin(), repeated.end());
  residual_.rest_but(chosen_);
}

void ModalBody::update_nodes(std::span<NodeState> state) {
  double largest = 0.0;
  for (std::size_t pack = 0; pack < shapes_.packs(); ++pack) {
    largest = std::max(largest, update_pack(pack, state));
  }
  largest_vibration_ = std::max(largest_vibration_, std::sqrt(largest));
}

double ModalBody::update_pack(std::size_t pack, std::span<NodeState> state) const {
  ModalShapes::Vibration vibration = shapes_.vibration(pack, places_, rates_);
  residual_.add(pack, vibration);
  const auto& [x, y, z] = vibration.displacement;
  PackVector arm;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    arm.at(axis) = arms_[pack].at(axis) + vibration.displacement.at(axis);
  }
  const Eigen::Matrix3d spinning = cross_matrix(frame_.spin()) * frame_.turn();
  const PackVector moved = times(frame_.turn_less_one(), arm);
  const PackVector carried = times(spinning, arm);
  const PackVector vibrating = times(frame_.turn(), vibration.velocity);
  Pack lines[solid::lanes] = {};  // of NodeState
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    lines[axis] = frame_.shift()[i] + (moved.at(axis) + vibration.displacement.at(axis));
    lines[3 + axis] = frame_.velocity()[i] + (carried.at(axis) + vibrating.at(axis));
  }
  const Pack squares = x * x + y * y + z * z;
  solid::transpose(lines);
  double largest = 0.0;
  for (std::size_t lane = 0; lane < solid::lanes && solid::lanes * pack + lane < masses_.size(); ++lane) {
    state[body_.owned_begin + solid::lanes * pack + lane] = std::bit_cast<NodeState>(lines[lane]);
    largest = std::max(largest, squares[lane]);
  }
  return largest;
}

void ModalBody::add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                         const Vector3& /*centre*/, const BodyUnits& unit, BodySums& sums) const {
  if (!is_here()) {
    return;
  }
  const Load now = load(force, state);
  const Eigen::Matrix3d change = change_of_moment();
  const FloatingFrame::Motion rigid = is_free_
                                          ? frame_.now(step, now.force, now.torque, change)
                                          : FloatingFrame::Motion{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 displacement = mass_ * frame_.shift();
  Vector3 momentum = mass_ * rigid.velocity;
  Vector3 angular = mass_ * frame_.shift().cross(rigid.velocity) + rigid.angular_momentum;
  Eigen::Matrix3d deformed = Eigen::Matrix3d::Zero();  // sum m (R sum q phi) (X - C)^T
  double kinetic = mass_ / 2 * rigid.velocity.squaredNorm() + rigid.spin.dot(rigid.angular_momentum) / 2;
  double elastic = 0.0;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Mode& mode = modes_[k];
    const double target = now.modal[k] / (mode.frequency * mode.frequency);
    const double after = mode.step.keep * rates_[k] + mode.step.pull * (target - places_[k]);
    const double rate =
        step.is_first() ? rates_[k] : (rates_[k] + after) / 2 * rate_correction(mode.frequency, step.length);
    if (!is_free_) {
      displacement += places_[k] * moments_[k].momentum;
      momentum += rate * moments_[k].momentum;
      angular += rate * moments_[k].angular;
    }
    deformed += places_[k] * frame_.turn() * moments_[k].cross;
    kinetic += rate * rate / 2;
    elastic += std::pow(mode.frequency * places_[k], 2) / 2;
  }
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
  sums.kinetic.add((kinetic + residual_.kinetic_energy()) / unit.mass);
  sums.elastic.add((elastic + residual_.elastic_energy()) / unit.mass);
}

void ModalBody::archive(parallel::Archive& archive) {
  const auto rows_of = [&](std::size_t count, std::size_t here) {
    std::vector<Index> numbers(here);
    std::iota(numbers.begin(), numbers.end(), 0);
    return parallel::Rows(numbers, static_cast<std::int64_t>(count), archive.communicator());
  };
  const std::string path = "motion/modal/" + name_;
  const bool here = is_here();
  if (!modes_.empty()) {
    archive.rows(path + "/modes", rows_of(modes_.size(), here ? modes_.size() : 0),
                 [this](std::size_t mode, parallel::ArchiveRow& row) {
                   row.value(places_[mode]);
                   row.value(rates_[mode]);
                 });
  }
  archive.rows(path + "/frame", rows_of(1, here ? 1 : 0), [this](std::size_t, parallel::ArchiveRow& row) {
    frame_.archive(row);
    row.value(largest_vibration_);
  });
  if (has_residual_) {
    archive.rows(path + "/residual", rows_of(nodes_, masses_.size()),
                 [this](std::size_t node, parallel::ArchiveRow& row) { residual_.archive(node, row); });
  }
}

}  // namespace idiophone::motion
