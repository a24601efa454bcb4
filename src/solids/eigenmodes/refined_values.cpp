#include "refined_values.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

using Matrix = Eigen::MatrixXd;

/// A column of a matrix as a vector of PETSc's.
class Column {
 public:
  Column(Matrix& matrix, Eigen::Index column) {
    petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, static_cast<PetscInt>(matrix.rows()), matrix.col(column).data(),
                                vector_.out()));
  }
  operator Vec() const { return vector_; }

 private:
  parallel::Handle<Vec> vector_;
};

/// [components x vectors] What a matrix makes of vectors.
Matrix images(Mat matrix, Matrix& vectors) {
  Matrix result(vectors.rows(), vectors.cols());
  for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
    petsc(MatMult(matrix, Column(vectors, i), Column(result, i)));
  }
  return result;
}

void append_columns(Matrix& vectors, const Matrix& others) {
  vectors.conservativeResize(others.rows(), vectors.cols() + others.cols());
  vectors.rightCols(others.cols()) = others;
}

/// [components x vectors] Vectors and their products with K and M.
struct Block {
  Block() = default;
  Block(const RefinedProblem& problem, Matrix of)
      : vectors(std::move(of)),
        stiffness(images(problem.stiffness(), vectors)),
        mass(images(problem.mass(), vectors)) {}

  void append(const Block& other) {
    if (other.vectors.cols() > 0) {
      append_columns(vectors, other.vectors);
      append_columns(stiffness, other.stiffness);
      append_columns(mass, other.mass);
    }
  }

  /// @param combinations  [vectors x vectors of the result]
  [[nodiscard]] Block combined(const Matrix& combinations) const {
    Block result;
    result.vectors = vectors * combinations;
    result.stiffness = stiffness * combinations;
    result.mass = mass * combinations;
    return result;
  }

  Matrix vectors;
  Matrix stiffness;
  Matrix mass;
};

/// The combinations of vectors that are M-orthonormal. There are fewer than vectors where these depend on each other.
/// @param mass  of the vectors, x^T M x
Matrix orthonormal_combinations(const Matrix& mass) {
  constexpr double dependent = 1e-12;  // square of a vector of unit mass that others make up
  const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
  const auto [lengths, axes] = dense::eigenpairs(Matrix(scale.asDiagonal() * mass * scale.asDiagonal()));
  const Eigen::Index kept = (lengths.array() > dependent).count();
  return scale.asDiagonal() * axes.rightCols(kept) * lengths.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// The lowest eigenvalues within a space, and their vectors as combinations, of unit modal mass.
struct Ritz {
  Eigen::VectorXd values;
  Matrix combinations;
};

Ritz ritz(const Block& space, Eigen::Index count) {
  const Matrix basis = orthonormal_combinations(space.vectors.transpose() * space.mass);
  const Matrix stiffness = basis.transpose() * (space.vectors.transpose() * space.stiffness) * basis;
  const auto [values, turned] = dense::eigenpairs(stiffness);
  const Eigen::Index found = std::min(count, basis.cols());
  return {values.head(found), basis * turned.leftCols(found)};
}

/// M-orthonormal vectors that others are kept orthogonal to. Large meshes have memory for them, but not for their
/// products with the matrices, too.
class KnownVectors {
 public:
  explicit KnownVectors(const RefinedProblem& problem) : problem_(problem) {}

  /// Takes them out of vectors.
  void deflate(Matrix& vectors) const {
    if (vectors_.cols() > 0) {
      const Matrix parts = vectors_.transpose() * images(problem_.mass(), vectors);
      vectors.noalias() -= vectors_ * parts;
    }
  }

  /// Adds the space of vectors that are orthogonal to them.
  void add(Matrix vectors) {
    if (vectors.cols() > 0) {
      append_columns(vectors_,
                     vectors * orthonormal_combinations(vectors.transpose() * images(problem_.mass(), vectors)));
    }
  }

 private:
  const RefinedProblem& problem_;
  Matrix vectors_;  // [components x vectors]
};

/// The directions in which the modes are to be improved.
Matrix directions(const RefinedProblem& problem, const Block& modes, const Eigen::VectorXd& values) {
  Matrix residuals = modes.stiffness - modes.mass * values.asDiagonal();
  Matrix result(residuals.rows(), residuals.cols());
  for (Eigen::Index i = 0; i < residuals.cols(); ++i) {
    problem.precondition(Column(residuals, i), Column(result, i));
  }
  return result;
}

/// Modes while they are improved.
struct Improvement {
  Block modes;
  Eigen::VectorXd values;
};

/// @param known  vectors that the modes are orthogonal to
Improvement improved(const RefinedProblem& problem, const Improvement& first, const KnownVectors& known) {
  constexpr int most_steps = 15;
  constexpr double little = 0.03;   // of what has been gained
  constexpr double unheard = 1e-6;  // of the eigenvalue
  const Eigen::Index count = first.values.size();
  Improvement now = first;
  Block before;  // the directions of the last step
  for (int step = 0; step < most_steps; ++step) {
    Matrix corrections = directions(problem, now.modes, now.values);
    known.deflate(corrections);
    Block space = now.modes;
    Block beside(problem, std::move(corrections));
    beside.append(before);
    space.append(beside);
    const Ritz best = ritz(space, count);
    const Eigen::ArrayXd gain = now.values - best.values;
    now.modes = space.combined(best.combinations);
    now.values = best.values;
    before = beside.combined(best.combinations.bottomRows(beside.vectors.cols()));
    const Eigen::ArrayXd enough = (little * (first.values - now.values).array()).max(unheard * now.values.array());
    if ((gain <= enough).all()) {
      break;
    }
  }
  return now;
}

/// Modes of the given mesh on the refined one, without what is known.
/// @param numbers  of the modes
Matrix interpolated(const RefinedProblem& problem, std::span<const std::vector<double>> shapes,
                    std::span<const std::size_t> numbers, const KnownVectors& known) {
  Matrix vectors(problem.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    problem.interpolate(shapes[numbers[i]], Column(vectors, static_cast<Eigen::Index>(i)));
  }
  known.deflate(vectors);
  return vectors;
}

/// The numbers below the last chosen one that are not chosen.
std::vector<std::size_t> not_chosen(std::span<const std::size_t> chosen) {
  std::vector<std::size_t> others;
  for (std::size_t mode = 0; mode < chosen.back(); ++mode) {
    if (!std::ranges::binary_search(chosen, mode)) {
      others.push_back(mode);
    }
  }
  return others;
}

/// Each motion's eigenvalue, and that of the improved mode that is most like it, of those that no other one got.
/// @param motions  interpolated, as many as modes
std::vector<RefinedValue> matched(const Block& motions, const Improvement& last) {
  const Eigen::VectorXd masses = motions.vectors.cwiseProduct(motions.mass).colwise().sum();
  const Eigen::VectorXd stiffness = motions.vectors.cwiseProduct(motions.stiffness).colwise().sum();
  Matrix likeness =
      masses.cwiseSqrt().cwiseInverse().asDiagonal() * (motions.mass.transpose() * last.modes.vectors).cwiseAbs();
  std::vector<RefinedValue> values(masses.size());
  for (std::size_t pairs = 0; pairs < values.size(); ++pairs) {
    Eigen::Index from = 0;
    Eigen::Index to = 0;
    likeness.maxCoeff(&from, &to);
    values[from] = {stiffness[from] / masses[from], last.values[to]};
    likeness.row(from).setConstant(-1);
    likeness.col(to).setConstant(-1);
  }
  return values;
}

}  // namespace

std::vector<RefinedValue> refined_values(const RefinedProblem& problem, std::span<const std::vector<double>> shapes,
                                         std::span<const std::size_t> chosen, const PartWatch& watch) {
  constexpr std::size_t at_once = 12;
  if (chosen.empty()) {
    return {};
  }
  KnownVectors known(problem);
  known.add(problem.rigid_motions());
  const std::vector<std::size_t> others = not_chosen(chosen);
  for (std::size_t first = 0; first < others.size(); first += at_once) {
    const auto next = std::span(others).subspan(first, std::min(at_once, others.size() - first));
    known.add(interpolated(problem, shapes, next, known));
  }
  std::vector<RefinedValue> all;
  for (bool goes_on = true; goes_on && all.size() < chosen.size();) {
    const auto next = chosen.subspan(all.size(), std::min(at_once, chosen.size() - all.size()));
    const Block motions(problem, interpolated(problem, shapes, next, known));
    const Ritz first = ritz(motions, motions.vectors.cols());
    const Improvement last = improved(problem, {motions.combined(first.combinations), first.values}, known);
    std::ranges::copy(matched(motions, last), std::back_inserter(all));
    known.add(last.modes.vectors);
    goes_on = !watch || watch(all.size(), chosen.size());
  }
  return all;
}

}  // namespace idiophone::eigenmodes
