#include "plane_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "inertia.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

PlaneProblem::PlaneProblem(const std::vector<bool>& held) {
  for (const bool is_held : held) {
    rows_.push_back(is_held ? -1 : size_++);
  }
  constexpr PetscInt row_length = 40;  // a first guess of its nonzeros; more is allowed
  for (parallel::Handle<Mat>* matrix : {&stiffness_, &mass_}) {
    petsc(MatCreateSeqAIJ(PETSC_COMM_SELF, size_, size_, row_length, nullptr, matrix->out()));
    petsc(MatSetOption(*matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
  }
}

void PlaneProblem::add(std::span<const Index> unknowns, const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass) {
  const auto count = static_cast<PetscInt>(unknowns.size());
  std::vector<PetscInt> rows;
  std::ranges::transform(unknowns, std::back_inserter(rows), [&](Index unknown) { return rows_[unknown]; });
  petsc(MatSetValues(stiffness_, count, rows.data(), count, rows.data(), stiffness.data(), ADD_VALUES));
  petsc(MatSetValues(mass_, count, rows.data(), count, rows.data(), mass.data(), ADD_VALUES));
}

void PlaneProblem::assemble() {
  for (const parallel::Handle<Mat>* matrix : {&stiffness_, &mass_}) {
    petsc(MatAssemblyBegin(*matrix, MAT_FINAL_ASSEMBLY));
    petsc(MatAssemblyEnd(*matrix, MAT_FINAL_ASSEMBLY));
    petsc(MatSetOption(*matrix, MAT_SYMMETRIC, PETSC_TRUE));
  }
}

parallel::Handle<Vec> PlaneProblem::restricted(const std::vector<double>& field) const {
  parallel::Handle<Vec> vector;
  petsc(MatCreateVecs(stiffness_, vector.out(), nullptr));
  PetscScalar* values = nullptr;
  petsc(VecGetArray(vector, &values));
  for (std::size_t unknown = 0; unknown < field.size(); ++unknown) {
    if (rows_[unknown] >= 0) {
      values[rows_[unknown]] = field[unknown];
    }
  }
  petsc(VecRestoreArray(vector, &values));
  return vector;
}

std::vector<double> PlaneProblem::extended(Vec vector) const {
  std::vector<double> field(rows_.size(), 0.0);
  const PetscScalar* values = nullptr;
  petsc(VecGetArrayRead(vector, &values));
  for (std::size_t unknown = 0; unknown < field.size(); ++unknown) {
    field[unknown] = rows_[unknown] < 0 ? 0.0 : values[rows_[unknown]];
  }
  petsc(VecRestoreArrayRead(vector, &values));
  return field;
}

std::vector<Eigenpair> wanted_eigenpairs(const PlaneProblem& problem, const std::string& body,
                                         const std::vector<std::vector<double>>& rigid_motions,
                                         const WantedModes& wanted, double shift) {
  const auto rigid = static_cast<PetscInt>(rigid_motions.size());
  if (problem.size() <= rigid) {
    throw NoModes(fmt::format("the {} has no modes: all of its mesh is held; make its size smaller", body));
  }
  PetscInt count = wanted.count;
  if (wanted.up_to) {
    count = eigenvalues_below(problem, std::pow(2 * std::numbers::pi * *wanted.up_to, 2)) - rigid;
    if (count < 1) {
      throw no_modes_up_to(*wanted.up_to, "the " + body, problem, rigid_motions, shift);
    }
  }
  if (count > problem.size() - rigid) {
    throw std::runtime_error(
        fmt::format("the {} has no more than {} modes on this mesh, not {}", body, problem.size() - rigid, count));
  }
  return lowest_eigenpairs(problem, rigid_motions, {static_cast<int>(count)}, shift);
}

double frequency_of(double eigenvalue) {
  return std::sqrt(eigenvalue) / (2 * std::numbers::pi);
}

void orient_shape(std::vector<double>& shape) {
  constexpr double as_large = 1 - 1e-3;
  const auto magnitude = [](double value) { return std::abs(value); };
  const double largest = std::abs(*std::ranges::max_element(shape, {}, magnitude));
  const auto first = std::ranges::find_if(shape, [&](double value) { return std::abs(value) >= as_large * largest; });
  if (*first < 0) {
    std::ranges::transform(shape, shape.begin(), std::negate());
  }
}

}  // namespace idiophone::eigenmodes
