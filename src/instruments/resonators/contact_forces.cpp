// The forces of contacts that feel each other.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "idiophone/instruments/resonators/point_contacts.hpp"

namespace idiophone::resonators {

namespace {

/// Makes `right` the solution x of matrix x = right, by Gauss' elimination with pivots in the columns.
/// @param matrix  [n x n] is lost
void solve(std::span<double> matrix, std::span<double> right) {
  const std::size_t n = right.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < n; ++row) {
      pivot = std::abs(matrix[row * n + column]) > std::abs(matrix[pivot * n + column]) ? row : pivot;
    }
    if (pivot != column) {
      std::swap_ranges(&matrix[column * n], &matrix[column * n] + n, &matrix[pivot * n]);
      std::swap(right[column], right[pivot]);
    }
    for (std::size_t row = column + 1; row < n; ++row) {
      const double factor = matrix[row * n + column] / matrix[column * n + column];
      for (std::size_t i = column; i < n; ++i) {
        matrix[row * n + i] -= factor * matrix[column * n + i];
      }
      right[row] -= factor * right[column];
    }
  }
  for (std::size_t row = n; row-- > 0;) {
    for (std::size_t i = row + 1; i < n; ++i) {
      right[row] -= matrix[row * n + i] * right[i];
    }
    right[row] /= matrix[row * n + row];
  }
}

}  // namespace

/// Each contact in turn finds its force. @return sum of the changes, N; 0 if all are rounding
double PointContacts::settle() {
  constexpr double rounding = 1e-15;
  const std::size_t count = touches_.size();
  bool changes = false;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double own = compliance_[i * count + i];
    const double force = touches_[i].contact->force(way(i) - own * forces_[i], own);
    const double change = std::abs(force - forces_[i]);
    changes |= count > 1 && change > rounding * std::abs(force);
    sum += change;
    forces_[i] = force;
  }
  return changes ? sum : 0.0;
}

/// Sum of what the forces differ from those of the ways that they cause, N.
double PointContacts::misfit() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    sum += std::abs(touches_[i].contact->force(way(i), 0.0) - forces_[i]);
  }
  return sum;
}

/// By a step for the equations force = F(way), whose slopes come from a small further way.
void PointContacts::find_newton_forces() {
  constexpr double small = 1e-6;
  const std::size_t count = touches_.size();
  double longest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    longest = std::max(longest, std::abs(way(i)));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double here = touches_[i].contact->force(way(i), 0.0);
    const double there = touches_[i].contact->force(way(i) + small * longest, 0.0);
    const double stiffness = longest > 0.0 ? std::max(0.0, (here - there) / (small * longest)) : 0.0;
    newton_forces_[i] = here - forces_[i];
    for (std::size_t j = 0; j < count; ++j) {
      matrix_[i * count + j] = stiffness * compliance_[i * count + j] + (i == j ? 1.0 : 0.0);
    }
  }
  solve(std::span(matrix_).first(count * count), std::span(newton_forces_).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    newton_forces_[i] += forces_[i];
  }
}

/// Takes Newton's step if the forces then fit better.
void PointContacts::correct() {
  const double before = misfit();
  find_newton_forces();
  std::swap(forces_, newton_forces_);
  if (!(misfit() < before)) {
    std::swap(forces_, newton_forces_);
  }
}

/// Small changes that do not shrink are rounding, too.
void PointContacts::find_forces() {
  constexpr int most_rounds = 100, rounds_alone = 20;
  constexpr double small = 1e-12;
  const auto add_size = [](double sum, double force) { return sum + std::abs(force); };
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    const double change = settle();
    const std::span<const double> forces = std::span(forces_).first(touches_.size());
    const double all = std::accumulate(forces.begin(), forces.end(), 0.0, add_size);
    if (change == 0.0 || (change >= before && change < small * all)) {
      return;
    }
    before = change;
    if (round >= rounds_alone) {
      correct();
    }
  }
}

}  // namespace idiophone::resonators
