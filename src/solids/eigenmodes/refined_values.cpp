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

/// [components x vectors] Vectors and their products with K and M.
struct Block {
  Block() = default;
  Block(const RefinedProblem& problem, Matrix of)
      : vectors(std::move(of)), stiffness(vectors.rows(), vectors.cols()), mass(vectors.rows(), vectors.cols()) {
    for (Eigen::Index i = 0; i < vectors.cols(); ++i) {
      const Column x(vectors, i);
      petsc(MatMult(problem.stiffness(), x, Column(stiffness, i)));
      petsc(MatMult(problem.mass(), x, Column(mass, i)));
    }
  }

  void append(const Block& other) {
    if (other.vectors.cols() == 0) {
      return;
    }
    const Eigen::Index before = vectors.cols();
    const Eigen::Index all = before + other.vectors.cols();
    const auto add = [&](Matrix& to, const Matrix& more) {
      to.conservativeResize(more.rows(), all);
      to.rightCols(all - before) = more;
    };
    add(vectors, other.vectors);
    add(stiffness, other.stiffness);
    add(mass, other.mass);
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

/// The lowest eigenvalues within a space, and their vectors as combinations, of unit modal mass. There are fewer where
/// vectors of the space depend on each other.
struct Ritz {
  Eigen::VectorXd values;
  Matrix combinations;
};

Ritz ritz(const Block& space, Eigen::Index count) {
  constexpr double dependent = 1e-12;  // square of a vector of unit mass that others make up
  const Matrix mass = space.vectors.transpose() * space.mass;
  const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
  const auto [lengths, axes] = dense::eigenpairs(Matrix(scale.asDiagonal() * mass * scale.asDiagonal()));
  const Eigen::Index kept = (lengths.array() > dependent).count();
  const Matrix basis =
      scale.asDiagonal() * axes.rightCols(kept) * lengths.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  const Matrix stiffness = basis.transpose() * (space.vectors.transpose() * space.stiffness) * basis;
  const auto [values, turned] = dense::eigenpairs(stiffness);
  const Eigen::Index found = std::min(count, kept);
  return {values.head(found), basis * turned.leftCols(found)};
}

/// Takes out of vectors what is known: K M-orthonormal vectors.
void deflate(Matrix& vectors, const Block& known) {
  if (known.vectors.cols() > 0) {
    vectors -= known.vectors * Matrix(known.mass.transpose() * vectors);
  }
}

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
Improvement improved(const RefinedProblem& problem, const Improvement& first, const Block& known) {
  constexpr int most_steps = 15;
  constexpr double little = 0.03;   // of what has been gained
  constexpr double unheard = 1e-6;  // of the eigenvalue
  const Eigen::Index count = first.values.size();
  Improvement now = first;
  Block before;  // the directions of the last step
  for (int step = 0; step < most_steps; ++step) {
    Matrix corrections = directions(problem, now.modes, now.values);
    deflate(corrections, known);
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
Block interpolated(const RefinedProblem& problem, std::span<const std::vector<double>> shapes,
                   std::span<const std::size_t> numbers, const Block& known) {
  Matrix vectors(problem.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    problem.interpolate(shapes[numbers[i]], Column(vectors, static_cast<Eigen::Index>(i)));
  }
  deflate(vectors, known);
  return {problem, std::move(vectors)};
}

/// The same space, spanned by K M-orthonormal vectors.
Block orthonormal(const Block& space) {
  const Eigen::Index count = space.vectors.cols();
  return count == 0 ? space : space.combined(ritz(space, count).combinations);
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
  Block known = orthonormal({problem, problem.rigid_motions()});
  known.append(orthonormal(interpolated(problem, shapes, not_chosen(chosen), known)));
  std::vector<RefinedValue> all;
  for (bool goes_on = true; goes_on && all.size() < chosen.size();) {
    const auto next = chosen.subspan(all.size(), std::min(at_once, chosen.size() - all.size()));
    const Block motions = interpolated(problem, shapes, next, known);
    const Ritz first = ritz(motions, motions.vectors.cols());
    const Improvement last = improved(problem, {motions.combined(first.combinations), first.values}, known);
    std::ranges::copy(matched(motions, last), std::back_inserter(all));
    known.append(last.modes);
    goes_on = !watch || watch(all.size(), chosen.size());
  }
  return all;
}

}  // namespace idiophone::eigenmodes
