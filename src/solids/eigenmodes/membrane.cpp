#include "idiophone/solids/eigenmodes/membrane.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "eigen_problem.hpp"
#include "eigensolver.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "inertia.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Gradient6 = Eigen::Matrix<double, 6, 2>;

/// A point of the reference triangle, by its coordinates along the edges from corner 0.
struct TrianglePoint {
  double xi, eta, weight;
};

/// Six points, exact up to degree 4 (Dunavant 1985); the weights add up to 1/2.
constexpr std::array<TrianglePoint, 6> quadrature = [] {
  constexpr double a = 0.816847572980459, b = 0.091576213509771, first = 0.109951743655322 / 2;
  constexpr double c = 0.108103018168070, d = 0.445948490915965, second = 0.223381589678011 / 2;
  return std::array<TrianglePoint, 6>{
      {{b, b, first}, {a, b, first}, {b, a, first}, {d, d, second}, {c, d, second}, {d, c, second}}};
}();

/// Stiffness and mass of one element.
struct ElementMatrices {
  Matrix6 stiffness = Matrix6::Zero();
  Matrix6 mass = Matrix6::Zero();
};

ElementMatrices element_matrices(const mesh::PlaneMesh& mesh, const std::array<Index, 6>& nodes,
                                 const Membrane& membrane) {
  Eigen::Matrix<double, 6, 2> places;
  for (int a = 0; a < 6; ++a) {
    places.row(a) << mesh.nodes[nodes[a]][0], mesh.nodes[nodes[a]][1];
  }
  ElementMatrices matrices;
  for (const auto& [xi, eta, weight] : quadrature) {
    const double rest = 1 - xi - eta;
    Vector6 shape;
    shape << rest * (2 * rest - 1), xi * (2 * xi - 1), eta * (2 * eta - 1), 4 * rest * xi, 4 * xi * eta, 4 * eta * rest;
    Gradient6 slope;  // by xi and eta
    slope << 1 - 4 * rest, 1 - 4 * rest, 4 * xi - 1, 0, 0, 4 * eta - 1, 4 * (rest - xi), -4 * xi, 4 * eta, 4 * xi,
        -4 * eta, 4 * (rest - eta);
    const Eigen::Matrix2d jacobian = places.transpose() * slope;
    const double area = weight * jacobian.determinant();
    const Gradient6 gradient = slope * jacobian.inverse();
    matrices.stiffness += membrane.tension * area * gradient * gradient.transpose();
    matrices.mass += membrane.density * area * shape * shape.transpose();
  }
  return matrices;
}

class MembraneProblem : public EigenProblem {
 public:
  MembraneProblem(const mesh::PlaneMesh& mesh, const Membrane& membrane) : numbers_(mesh.nodes.size(), 0) {
    for (const Index node : mesh.rim) {
      numbers_[node] = -1;
    }
    for (PetscInt& number : numbers_) {
      number = number < 0 ? -1 : size_++;
    }
    constexpr PetscInt row_length = 40;  // a first guess of its nonzeros; more is allowed
    for (parallel::Handle<Mat>* matrix : {&stiffness_, &mass_}) {
      petsc(MatCreateSeqAIJ(PETSC_COMM_SELF, size_, size_, row_length, nullptr, matrix->out()));
      petsc(MatSetOption(*matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
    }
    for (const auto& nodes : mesh.elements) {
      const ElementMatrices matrices = element_matrices(mesh, nodes, membrane);
      std::array<PetscInt, 6> rows;
      std::ranges::transform(nodes, rows.begin(), [&](Index node) { return numbers_[node]; });
      petsc(MatSetValues(stiffness_, 6, rows.data(), 6, rows.data(), matrices.stiffness.data(), ADD_VALUES));
      petsc(MatSetValues(mass_, 6, rows.data(), 6, rows.data(), matrices.mass.data(), ADD_VALUES));
    }
    for (const parallel::Handle<Mat>* matrix : {&stiffness_, &mass_}) {
      petsc(MatAssemblyBegin(*matrix, MAT_FINAL_ASSEMBLY));
      petsc(MatAssemblyEnd(*matrix, MAT_FINAL_ASSEMBLY));
      petsc(MatSetOption(*matrix, MAT_SYMMETRIC, PETSC_TRUE));
    }
  }

  [[nodiscard]] Mat stiffness() const override { return stiffness_; }
  [[nodiscard]] Mat mass() const override { return mass_; }
  [[nodiscard]] PetscInt size() const { return size_; }

  [[nodiscard]] parallel::Handle<Vec> restricted(const std::vector<double>& field) const override {
    parallel::Handle<Vec> vector;
    petsc(MatCreateVecs(stiffness_, vector.out(), nullptr));
    PetscScalar* values = nullptr;
    petsc(VecGetArray(vector, &values));
    for (std::size_t node = 0; node < field.size(); ++node) {
      if (numbers_[node] >= 0) {
        values[numbers_[node]] = field[node];
      }
    }
    petsc(VecRestoreArray(vector, &values));
    return vector;
  }

  [[nodiscard]] std::vector<double> extended(Vec vector) const override {
    std::vector<double> field(numbers_.size(), 0.0);
    const PetscScalar* values = nullptr;
    petsc(VecGetArrayRead(vector, &values));
    for (std::size_t node = 0; node < field.size(); ++node) {
      field[node] = numbers_[node] < 0 ? 0.0 : values[numbers_[node]];
    }
    petsc(VecRestoreArrayRead(vector, &values));
    return field;
  }

 private:
  std::vector<PetscInt> numbers_;  ///< [nodes] row of each; -1 at the rim
  PetscInt size_ = 0;
  parallel::Handle<Mat> stiffness_;
  parallel::Handle<Mat> mass_;
};

/// Turns the sign of a shape so that its largest value is positive; of values that are as large, the first counts.
void orient_shape(std::vector<double>& shape) {
  constexpr double as_large = 1 - 1e-3;
  const auto magnitude = [](double value) { return std::abs(value); };
  const double largest = std::abs(*std::ranges::max_element(shape, {}, magnitude));
  const auto first = std::ranges::find_if(shape, [&](double value) { return std::abs(value) >= as_large * largest; });
  if (*first < 0) {
    std::ranges::transform(shape, shape.begin(), std::negate());
  }
}

}  // namespace

std::vector<MembraneMode> membrane_modes(const mesh::PlaneMesh& mesh, const Membrane& membrane, int count,
                                         std::optional<double> up_to) {
  constexpr double turn = 2 * std::numbers::pi;
  const MembraneProblem problem(mesh, membrane);
  const PetscInt wanted = up_to ? eigenvalues_below(problem, std::pow(turn * *up_to, 2)) : count;
  if (wanted < 1) {
    throw NoModes(fmt::format("the membrane has no modes up to {} Hz", *up_to));
  }
  if (wanted > problem.size()) {
    throw std::runtime_error(
        fmt::format("the membrane has no more than {} modes on this mesh, not {}", problem.size(), wanted));
  }
  std::vector<MembraneMode> modes;
  for (Eigenpair& pair : lowest_eigenpairs(problem, {}, static_cast<int>(wanted), 0.0)) {
    orient_shape(pair.vector);
    modes.push_back({std::sqrt(pair.value) / turn, std::move(pair.vector)});
  }
  return modes;
}

}  // namespace idiophone::eigenmodes
