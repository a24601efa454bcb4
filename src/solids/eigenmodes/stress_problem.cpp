#include "stress_problem.hpp"

#include <petscmat.h>

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

/// Integrals over an element of products of two nodes' shape functions.
class NodeProducts {
 public:
  /// @param slope_weights  [points] those of products of slopes
  NodeProducts(const Eigen::VectorXd& weights, const Eigen::VectorXd& slope_weights, const ShapeTable& table)
      : values_(table.values.transpose() * weights.asDiagonal() * table.values) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::MatrixXd weighted = slope_weights.asDiagonal() * table.slopes[k];
      slopes_[k][k] = table.slopes[k].transpose() * weighted;
      for (int l = 0; l < k; ++l) {
        slopes_[l][k] = table.slopes[l].transpose() * weighted;
        slopes_[k][l] = slopes_[l][k].transpose();
      }
    }
  }

  /// Of the six stresses at node a and those at node b: their complementary energy, and the product of their
  /// divergences.
  [[nodiscard]] dense::Matrix6 block(Eigen::Index a, Eigen::Index b, const dense::Matrix6& compliance) const {
    dense::Matrix6 result = values_(a, b) * compliance;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) {
          result(stress_component(i, k), stress_component(i, l)) += slopes_[k][l](a, b);
        }
      }
    }
    return result;
  }

 private:
  Eigen::MatrixXd values_;
  std::array<std::array<Eigen::MatrixXd, 3>, 3> slopes_;  ///< [k][l] of the derivatives along k of a and along l of b
};

/// The weighted least squares problem: its unknowns are those of the StressSpace.
class StressProblem {
 public:
  StressProblem(const ElasticModes& modes, const StressSpace& space, double shift)
      : modes_(modes),
        space_(space),
        shift_(shift),
        compliance_(modes.stiffness.inverse()),
        rule_(space.type()),
        displacements_(modes.mesh.element, rule_.points),
        stresses_(space.type(), rule_.points) {
    create_matrix();
    right_ = Eigen::MatrixXd::Zero(space.size(), modes.shapes.cols());
    for (Index element = 0; element < modes.mesh.element_count(); ++element) {
      add_element(element);
    }
    petsc(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    petsc(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
    petsc(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
  }

  /// [unknowns x modes]
  [[nodiscard]] Eigen::MatrixXd solve() {
    parallel::Handle<Mat> factors;
    petsc(MatGetFactor(matrix_, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factors.out()));
    petsc(MatSetOptionsPrefix(factors, "bounds_"));
    MatFactorInfo settings;
    petsc(MatFactorInfoInitialize(&settings));
    petsc(MatCholeskyFactorSymbolic(factors, matrix_, nullptr, &settings));
    petsc(MatCholeskyFactorNumeric(factors, matrix_, &settings));
    MatFactorError error = MAT_FACTOR_NOERROR;
    petsc(MatFactorGetError(factors, &error));
    if (error != MAT_FACTOR_NOERROR) {
      throw std::runtime_error(
          "no bounds, as MUMPS can't factorise the matrix of the stresses: use a coarser mesh or more memory");
    }
    Eigen::MatrixXd solution(right_.rows(), right_.cols());
    const auto modes = static_cast<PetscInt>(right_.cols());
    parallel::Handle<Mat> right;
    parallel::Handle<Mat> found;
    petsc(MatCreateSeqDense(PETSC_COMM_SELF, space_.size(), modes, right_.data(), right.out()));
    petsc(MatCreateSeqDense(PETSC_COMM_SELF, space_.size(), modes, solution.data(), found.out()));
    petsc(MatMatSolve(factors, right, found));
    return solution;
  }

  /// @param solution  [unknowns x modes]
  [[nodiscard]] StressDefects defects(const Eigen::MatrixXd& solution) const {
    const Eigen::Index count = modes_.shapes.cols();
    StressDefects sums{Eigen::MatrixXd::Zero(count, count), Eigen::MatrixXd::Zero(count, count)};
    for (Index element = 0; element < modes_.mesh.element_count(); ++element) {
      const ElementPoints points = points_of(element);
      const ModeFields fields(displacements_.on(points), modes_.mesh.element_nodes(element), modes_.shapes);
      const ShapeTable table = stresses_.on(points);
      const auto nodal = nodal_stresses(element, solution);
      std::array<Eigen::MatrixXd, 6> difference = combined(-modes_.stiffness, fields.strain);
      for (int r = 0; r < 6; ++r) {
        difference[r] += table.values * nodal[r];
      }
      std::array<Eigen::MatrixXd, 3> residual;
      for (int i = 0; i < 3; ++i) {
        residual[i] = fields.displacement[i] * (modes_.density * modes_.values).asDiagonal();
        for (int k = 0; k < 3; ++k) {
          residual[i] += table.slopes[k] * nodal[stress_component(i, k)];
        }
      }
      add_integral(points.weights, difference, combined(compliance_, difference), sums.energy);
      add_integral(points.weights / modes_.density, residual, residual, sums.equation);
    }
    return sums;
  }

 private:
  [[nodiscard]] ElementPoints points_of(Index element) const {
    return displacements_.points_of(modes_.mesh, element, rule_.weights);
  }

  /// With room wherever two unknowns share an element, in the upper triangle.
  void create_matrix() {
    std::vector<std::vector<Index>> neighbours(space_.nodes());
    for (Index element = 0; element < modes_.mesh.element_count(); ++element) {
      const auto nodes = space_.element_nodes(element);
      for (const Index node : nodes) {
        std::ranges::copy_if(nodes, std::back_inserter(neighbours[node]), [&](Index other) { return other >= node; });
      }
    }
    std::vector<PetscInt> lengths;
    for (std::size_t node = 0; node < neighbours.size(); ++node) {
      keep_each_once(neighbours[node]);
      PetscInt length = 0;
      for (const Index other : neighbours[node]) {
        length += space_.first(other + 1) - space_.first(other);
      }
      for (PetscInt row = space_.first(node); row < space_.first(node + 1); ++row) {
        lengths.push_back(length--);
      }
    }
    petsc(MatCreateSeqSBAIJ(PETSC_COMM_SELF, 1, space_.size(), space_.size(), 0, lengths.data(), matrix_.out()));
    petsc(MatSetOption(matrix_, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
  }

  void add_element(Index element) {
    const ElementPoints points = points_of(element);
    const ShapeTable table = stresses_.on(points);
    add_matrix(element, points, table);
    add_right(element, points, table);
  }

  void add_matrix(Index element, const ElementPoints& points, const ShapeTable& table) {
    const NodeProducts products(points.weights, points.weights / (modes_.density * shift_), table);
    const auto nodes = space_.element_nodes(element);
    std::vector<PetscInt> numbers;
    for (const Index node : nodes) {
      for (PetscInt number = space_.first(node); number < space_.first(node + 1); ++number) {
        numbers.push_back(number);
      }
    }
    const auto size = static_cast<PetscInt>(numbers.size());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> matrix(size, size);
    Eigen::Index row = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const StressSpace::NodeBasis& left = space_.basis(nodes[a]);
      Eigen::Index column = 0;
      for (std::size_t b = 0; b < nodes.size(); ++b) {
        const StressSpace::NodeBasis& right = space_.basis(nodes[b]);
        const dense::Matrix6 half = products.block(a, b, compliance_) * right.vectors;
        const dense::Matrix6 block = left.vectors.transpose() * half;
        matrix.block(row, column, left.count, right.count) = block.topLeftCorner(left.count, right.count);
        column += right.count;
      }
      row += left.count;
    }
    petsc(MatSetValues(matrix_, size, numbers.data(), size, numbers.data(), matrix.data(), ADD_VALUES));
  }

  void add_right(Index element, const ElementPoints& points, const ShapeTable& table) {
    const ModeFields fields(displacements_.on(points), modes_.mesh.element_nodes(element), modes_.shapes);
    std::array<Eigen::MatrixXd, 6> nodal;
    for (int r = 0; r < 6; ++r) {
      nodal[r] = table.values.transpose() * (points.weights.asDiagonal() * fields.strain[r]);
    }
    for (int i = 0; i < 3; ++i) {
      const Eigen::MatrixXd force =
          points.weights.asDiagonal() * fields.displacement[i] * (modes_.values / shift_).asDiagonal();
      for (int k = 0; k < 3; ++k) {
        nodal[stress_component(i, k)] -= table.slopes[k].transpose() * force;
      }
    }
    const auto nodes = space_.element_nodes(element);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const StressSpace::NodeBasis& basis = space_.basis(nodes[a]);
      for (int r = 0; r < 6; ++r) {
        right_.middleRows(space_.first(nodes[a]), basis.count) +=
            basis.vectors.row(r).head(basis.count).transpose() * nodal[r].row(a);
      }
    }
  }

  /// [components][nodes of the element x modes], Pa
  [[nodiscard]] std::array<Eigen::MatrixXd, 6> nodal_stresses(Index element, const Eigen::MatrixXd& solution) const {
    const auto nodes = space_.element_nodes(element);
    std::array<Eigen::MatrixXd, 6> nodal;
    nodal.fill(Eigen::MatrixXd(nodes.size(), solution.cols()));
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const StressSpace::NodeBasis& basis = space_.basis(nodes[a]);
      const Eigen::MatrixXd all =
          basis.vectors.leftCols(basis.count) * solution.middleRows(space_.first(nodes[a]), basis.count);
      for (int r = 0; r < 6; ++r) {
        nodal[r].row(static_cast<Eigen::Index>(a)) = all.row(r);
      }
    }
    return nodal;
  }

  const ElasticModes& modes_;
  const StressSpace& space_;
  double shift_;
  dense::Matrix6 compliance_;
  CubeRule rule_;
  ShapesAtPoints displacements_;
  ShapesAtPoints stresses_;
  parallel::Handle<Mat> matrix_;
  Eigen::MatrixXd right_;  ///< [unknowns x modes]
};

}  // namespace

StressDefects least_defects(const ElasticModes& modes, const StressSpace& space, double shift) {
  StressProblem problem(modes, space, shift);
  return problem.defects(problem.solve());
}

}  // namespace idiophone::eigenmodes
