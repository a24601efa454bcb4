// Columns with added mass some of whose components are held: dense matrices of one column.

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/solids/solid/added_mass.hpp"

namespace idiophone::solid {

namespace {

constexpr int most = 3 * (element::highest_hex_order + 1);

/// Of the components of one column, without memory from the heap.
using ColumnMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
using ColumnVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
using Shapes = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, most>;  // of both shapes' vectors
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Where a column is.
struct Pose {
  Vector3 director;
  Vector3 lean;
};

Pose pose(const std::array<Vector3, 2>& spread) {
  const double length = spread[0].norm();
  const Vector3 director = spread[0] / length;
  return {director, (spread[1] - director.dot(spread[1]) * director) / length};
}

/// The mass matrix of a column, kg; components are 3 level + axis.
template <class Column>
ColumnMatrix mass_matrix(const Column& column, const Pose& now) {
  const auto count = static_cast<Eigen::Index>(column.members.size());
  ColumnVector diagonal(3 * count);
  ColumnVector stretch(3 * count);  // gradient of the length
  ColumnVector bow(3 * count);      // gradient of the bow
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& [node, inverse_mass, weight] = column.members[k];
    diagonal.segment<3>(3 * k).setConstant(1 / inverse_mass);
    stretch.segment<3>(3 * k) = weight[0] * now.director;
    bow.segment<3>(3 * k) = weight[1] * now.director + weight[0] * now.lean;
  }
  ColumnMatrix matrix = column.along[0] * stretch * stretch.transpose() + column.along[1] * bow * bow.transpose();
  matrix.diagonal() += diagonal;
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index l = 0; l < count; ++l) {
      const auto& a = column.members[k].weight;
      const auto& b = column.members[l].weight;
      matrix.block<3, 3>(3 * k, 3 * l).diagonal().array() +=
          column.isotropic[0] * a[0] * b[0] + column.isotropic[1] * a[1] * b[1];
    }
  }
  return matrix;
}

/// C: what a pull on the two shapes changes their acceleration by.
template <class Column>
Matrix6 shape_compliance(const Column& column, const Pose& now) {
  const double first = 1 / (1 + column.isotropic[0]);
  const double second = 1 / (1 + column.isotropic[1]);
  Eigen::Matrix<double, 6, 1> stretch = Eigen::Matrix<double, 6, 1>::Zero();
  stretch.head<3>() = first * now.director;
  Eigen::Matrix<double, 6, 1> bow;
  bow << first * now.lean, second * now.director;
  const double by_stretch = column.along[0] / (1 + column.along[0] * first);
  const double by_bow = column.along[1] / (1 + column.along[1] * (second + first * now.lean.squaredNorm()));
  Matrix6 matrix = -by_stretch * stretch * stretch.transpose() - by_bow * bow * bow.transpose();
  matrix.diagonal().head<3>().array() += first - 1;
  matrix.diagonal().tail<3>().array() += second - 1;
  return matrix;
}

}  // namespace

void AddedMass::add_held(std::size_t number, const Column& column, std::span<const Index> held) {
  HeldColumn result{.column = column, .held = {}, .free = {}, .place = {}, .inverse_root = {}};
  for (int component = 0; component < 3 * static_cast<int>(levels_); ++component) {
    const Index wanted = 3 * column.members[component / 3].node + component % 3;
    const auto found = std::ranges::lower_bound(held, wanted);
    if (found != held.end() && *found == wanted) {
      result.held.push_back(component);
      result.place.push_back(found - held.begin());
    } else {
      result.free.push_back(component);
    }
  }
  if (result.held.empty()) {
    return;
  }
  // In coordinates in which the lumped mass is 1; as in `entries`, an undeformed column is taken as straight.
  const ColumnMatrix mass = mass_matrix(column, {pose(column.spread).director, Vector3::Zero()});
  ColumnVector inverse_roots(mass.rows());
  for (Eigen::Index c = 0; c < mass.rows(); ++c) {
    inverse_roots[c] = std::sqrt(column.members[c / 3].inverse_mass);
  }
  const ColumnMatrix relative = inverse_roots.asDiagonal() * mass * inverse_roots.asDiagonal();
  result.inverse_root = dense::inverse_root(relative(result.free, result.free));
  held_.emplace(number, std::move(result));
}

void AddedMass::apply_held_root(const HeldColumn& held, std::span<double> x) const {
  const auto at = [&](int component) -> double& {
    return x[3 * (held.column.members[component / 3].node - begin_) + component % 3];
  };
  Eigen::VectorXd free(std::ssize(held.free));
  std::ranges::transform(held.free, free.begin(), at);
  free = held.inverse_root * free;
  for (std::size_t i = 0; i < held.free.size(); ++i) {
    at(held.free[i]) = free[static_cast<Eigen::Index>(i)];
  }
  for (const int component : held.held) {
    at(component) = 0.0;
  }
}

// The inverse of a column's mass is that of the lumped masses plus a matrix of low rank: with y = sum of w/m f of each
// shape, a = (f + w C y)/m, C the matrix of added_mass_motion.cpp's equations without velocities.
void AddedMass::impose(std::span<const double> velocities, std::span<NodeState> state,
                       std::span<double> impulses) const {
  for (const auto& [number, held] : held_) {
    const std::span<const ColumnNode> members = held.column.members;
    std::array<Vector3, 2> spread = held.column.spread;
    for (const ColumnNode& member : members) {
      for (std::size_t s = 0; s < 2; ++s) {
        spread[s] += member.weight[s] * Eigen::Map<const Vector3>(state[member.node].displacement);
      }
    }
    const Matrix6 compliance = shape_compliance(held.column, pose(spread));
    const auto count = static_cast<Eigen::Index>(held.held.size());
    Shapes shapes(6, count);  // w/m of each held component
    ColumnVector change(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto& [node, inverse_mass, weight] = members[held.held[i] / 3];
      const int axis = held.held[i] % 3;
      shapes.col(i).setZero();
      shapes(axis, i) = weight[0] * inverse_mass;
      shapes(3 + axis, i) = weight[1] * inverse_mass;
      change[i] = velocities[held.place[i]] - state[node].velocity[axis];
    }
    ColumnMatrix inverse = shapes.transpose() * (compliance * shapes).eval();
    for (Eigen::Index i = 0; i < count; ++i) {
      inverse(i, i) += members[held.held[i] / 3].inverse_mass;
    }
    const ColumnVector impulse = inverse.llt().solve(change);
    const Eigen::Matrix<double, 6, 1> along = compliance * (shapes * impulse);
    for (const ColumnNode& member : members) {
      Eigen::Map<Vector3>(state[member.node].velocity) +=
          member.inverse_mass * (member.weight[0] * along.head<3>() + member.weight[1] * along.tail<3>());
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      state[members[held.held[i] / 3].node].velocity[held.held[i] % 3] = velocities[held.place[i]];
      if (!impulses.empty()) {
        impulses[held.place[i]] += impulse[i];
      }
    }
  }
}

}  // namespace idiophone::solid
