#include "idiophone/solid/added_mass.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::solid {

namespace {

Eigen::Map<const Vector3> vector(const double (&components)[3]) {
  return Eigen::Map<const Vector3>(components);
}

/// The lines of nodes through the thickness of all elements, each once, nodes from one face to the other.
std::vector<std::vector<Index>> find_columns(const mesh::BodyPart& body) {
  const int in_plane = (body.element.plane + 1) * (body.element.plane + 1);
  std::vector<std::vector<Index>> columns;
  std::vector<std::ptrdiff_t> column_of;
  for (std::size_t e = 0; e < body.element_ids.size(); ++e) {
    const auto nodes = body.element_nodes(e);
    for (int line = 0; line < in_plane; ++line) {
      std::vector<Index> column;
      for (int k = 0; k <= body.element.thickness; ++k) {
        column.push_back(nodes[line + in_plane * k]);
      }
      const Index largest = *std::ranges::max_element(column);
      if (largest >= std::ssize(column_of)) {
        column_of.resize(largest + 1, -1);
      }
      const std::ptrdiff_t known = column_of[column.front()];
      if (std::ranges::any_of(column, [&](Index node) { return column_of[node] != known; })) {
        throw std::runtime_error(
            fmt::format("mass_scaling needs one layer of hexahedra through the thickness, all with their third "
                        "direction across it: element {} shares a part of a column of nodes with another",
                        body.element_ids[e]));
      }
      if (known < 0) {
        for (const Index node : column) {
          column_of[node] = std::ssize(columns);
        }
        columns.push_back(std::move(column));
      }
    }
  }
  return columns;
}

}  // namespace

/// Where a column is now.
struct AddedMass::Pose {
  Vector3 director;  ///< n
  Vector3 lean;      ///< the part of D_quadratic at right angles to n, over |D_linear|
  double length;     ///< L = |D_linear|, kg^1/2 m
  double bow;        ///< B = n . D_quadratic, kg^1/2 m
};

AddedMass::AddedMass(const mesh::BodyPart& body, std::span<const Vector3> reference, std::span<const double> lumped,
                     std::span<const char> held, const std::function<MassScaling(double)>& scaling)
    : begin_(body.owned_begin), has_(lumped.size()) {
  const auto is_owned = [&](Index node) { return node >= body.owned_begin && node < body.owned_end; };
  for (const std::vector<Index>& nodes : find_columns(body)) {
    if (std::ranges::all_of(nodes, is_owned) &&
        std::ranges::none_of(nodes, [&](Index node) { return held[node - begin_] != 0; })) {
      add_column(nodes, reference, lumped, scaling);
    }
  }
}

void AddedMass::add_column(std::span<const Index> nodes, std::span<const Vector3> reference,
                           std::span<const double> lumped, const std::function<MassScaling(double)>& scaling) {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  const Vector3 across = reference[nodes.back()] - reference[nodes.front()];
  Eigen::VectorXd mass(count);
  Eigen::VectorXd height(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    mass[i] = lumped[nodes[i] - begin_];
    height[i] = (reference[nodes[i]] - reference[nodes.front()]).dot(across.normalized());
  }
  const auto product = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (mass.array() * a.array() * b.array()).sum();
  };
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(count);
  const Eigen::VectorXd linear = height - product(one, height) / product(one, one) * one;
  Eigen::VectorXd quadratic = linear.array().square();
  quadratic -=
      product(one, quadratic) / product(one, one) * one + product(linear, quadratic) / product(linear, linear) * linear;
  const std::array<Eigen::VectorXd, 2> shapes = {linear / std::sqrt(product(linear, linear)),
                                                 quadratic / std::sqrt(product(quadratic, quadratic))};
  const MassScaling factor = scaling(across.norm());
  Column column{.first = members_.size(),
                .count = nodes.size(),
                .spread = {Vector3::Zero(), Vector3::Zero()},
                .isotropic = {factor.rotation, factor.plane_bow},
                .along = {factor.stretch - factor.rotation, factor.bow - factor.plane_bow}};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Member member{nodes[i], 1 / mass[i], {mass[i] * shapes[0][i], mass[i] * shapes[1][i]}};
    for (std::size_t s = 0; s < 2; ++s) {
      // Measured from one of the nodes: the weights add up to zero.
      column.spread[s] += member.weight[s] * (reference[nodes[i]] - reference[nodes.front()]);
    }
    members_.push_back(member);
    has_[nodes[i] - begin_] = 1;
  }
  columns_.push_back(column);
}

AddedMass::Pose AddedMass::pose(const Column& column, const NodeState* state) const {
  std::array<Vector3, 2> spread = column.spread;
  for (const Member& member : members(column)) {
    const auto displacement = vector(state[member.node].displacement);
    spread[0] += member.weight[0] * displacement;
    spread[1] += member.weight[1] * displacement;
  }
  const double length = spread[0].norm();
  const Vector3 director = spread[0] / length;
  const double bow = director.dot(spread[1]);
  return {.director = director, .lean = (spread[1] - bow * director) / length, .length = length, .bow = bow};
}

// Lagrange's equations of the added energies, for the acceleration A of each D and the force F on it, which is the
// acceleration that it would have without them:
//   (1 + b_1) A_1 = F_1 - p_1 n - p_2 lean,  p_1 = c_1 L'',  L'' = n . A_1 + L w^2,
//   (1 + b_2) A_2 = F_2 - p_2 n,  p_2 = c_2 B'',  B'' = n . A_2 + lean . A_1 + 2 n' . D_2' - 2 L'/L n' . D_2 - w^2 B,
// with w = |n'|.
std::array<Vector3, 2> AddedMass::acceleration_change(const Column& column, const NodeState* state,
                                                      const NodeForce* force) const {
  std::array<Vector3, 2> rate = {Vector3::Zero(), Vector3::Zero()};
  std::array<Vector3, 2> pull = {Vector3::Zero(), Vector3::Zero()};
  for (const Member& member : members(column)) {
    const auto& f = force[member.node].component;
    const Vector3 acceleration = member.inverse_mass * Vector3(f[0], f[1], f[2]);
    for (std::size_t s = 0; s < 2; ++s) {
      rate[s] += member.weight[s] * vector(state[member.node].velocity);
      pull[s] += member.weight[s] * acceleration;
    }
  }
  const auto [director, lean, length, bow] = pose(column, state);
  const double stretching = director.dot(rate[0]);
  const Vector3 turning = (rate[0] - stretching * director) / length;  // n'
  const double square = turning.squaredNorm();
  const double compliance[2] = {1 / (1 + column.isotropic[0]), 1 / (1 + column.isotropic[1])};
  const double stretch = compliance[0] * director.dot(pull[0]) + length * square;
  const double bend = compliance[1] * director.dot(pull[1]) + compliance[0] * lean.dot(pull[0]) +
                      2 * turning.dot(rate[1]) - 2 * stretching * turning.dot(lean) - square * bow;
  const double p_1 = column.along[0] / (1 + column.along[0] * compliance[0]) * stretch;
  const double p_2 =
      column.along[1] / (1 + column.along[1] * (compliance[1] + compliance[0] * lean.squaredNorm())) * bend;
  return {compliance[0] * (pull[0] - p_1 * director - p_2 * lean) - pull[0],
          compliance[1] * (pull[1] - p_2 * director) - pull[1]};
}

std::array<Vector3, 2> AddedMass::momentum(const Column& column, const NodeState* state,
                                           std::span<const Vector3> velocity) const {
  std::array<Vector3, 2> rate = {Vector3::Zero(), Vector3::Zero()};
  for (const Member& member : members(column)) {
    for (std::size_t s = 0; s < 2; ++s) {
      rate[s] += member.weight[s] * velocity[member.node];
    }
  }
  const Pose now = pose(column, state);
  const double stretching = now.director.dot(rate[0]);
  const double bowing = now.director.dot(rate[1]) + now.lean.dot(rate[0]);
  return {
      column.isotropic[0] * rate[0] + column.along[0] * stretching * now.director + column.along[1] * bowing * now.lean,
      column.isotropic[1] * rate[1] + column.along[1] * bowing * now.director};
}

void AddedMass::apply_inverse_root(std::span<double> x) const {
  const auto part = [](double added) { return 1 - 1 / std::sqrt(1 + added); };
  for (const Column& column : columns_) {
    const Vector3 director = column.spread[0].normalized();
    std::array<Vector3, 2> change = {Vector3::Zero(), Vector3::Zero()};
    for (std::size_t s = 0; s < 2; ++s) {
      for (const Member& member : members(column)) {
        const Eigen::Map<const Vector3> at(&x[3 * (member.node - begin_)]);
        change[s] += member.weight[s] * std::sqrt(member.inverse_mass) * at;
      }
      const double across = part(column.isotropic[s]);
      const double along = part(column.isotropic[s] + column.along[s]);
      change[s] = across * change[s] + (along - across) * director.dot(change[s]) * director;
    }
    for (const Member& member : members(column)) {
      Eigen::Map<Vector3>(&x[3 * (member.node - begin_)]) -=
          std::sqrt(member.inverse_mass) * (member.weight[0] * change[0] + member.weight[1] * change[1]);
    }
  }
}

Eigen::Matrix3d AddedMass::entries(const Column& column, const Member& row, const Member& other) {
  const Vector3 director = column.spread[0].normalized();
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  for (std::size_t s = 0; s < 2; ++s) {
    block += row.weight[s] * other.weight[s] *
             (column.isotropic[s] * Eigen::Matrix3d::Identity() + column.along[s] * director * director.transpose());
  }
  return block;
}

int AddedMass::longest() const {
  std::size_t longest = 1;
  for (const Column& column : columns_) {
    longest = std::max(longest, column.count);
  }
  return static_cast<int>(longest);
}

}  // namespace idiophone::solid
