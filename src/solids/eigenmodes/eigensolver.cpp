#include "eigensolver.hpp"

#include <fmt/format.h>
#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "inertia.hpp"
#include "shifted_matrix.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

/// Orthogonal vectors that a search leaves out: rigid motions and modes that are known.
using Known = std::vector<parallel::Handle<Vec>>;

/// Krylov-Schur, set up, for (K + shift M) x = (lambda + shift) M x about zero: SLEPc needs no other shift then.
/// @param shifted  K + shift M
parallel::Handle<EPS> create_solver(const EigenProblem& problem, Mat shifted, int count) {
  parallel::Handle<EPS> solver;
  petsc(EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(problem.stiffness())), solver.out()));
  petsc(EPSSetOptionsPrefix(solver, "modes_"));
  petsc(EPSSetOperators(solver, shifted, problem.mass()));
  petsc(EPSSetProblemType(solver, EPS_GHEP));
  petsc(EPSSetDimensions(solver, count, PETSC_DEFAULT, PETSC_DEFAULT));
  petsc(EPSSetWhichEigenpairs(solver, EPS_TARGET_MAGNITUDE));
  petsc(EPSSetTarget(solver, 0.0));
  petsc(EPSSetTolerances(solver, 1e-10, 1000));
  petsc(EPSSetPurify(solver, PETSC_FALSE));  // a solve for each vector, which only a singular M needs
  ST transformation = nullptr;
  KSP linear = nullptr;
  PC factors = nullptr;
  petsc(EPSGetST(solver, &transformation));
  petsc(STSetType(transformation, STSINVERT));
  petsc(STSetMatStructure(transformation, SUBSET_NONZERO_PATTERN));
  petsc(STGetKSP(transformation, &linear));
  petsc(KSPSetType(linear, KSPPREONLY));
  petsc(KSPGetPC(linear, &factors));
  petsc(PCSetType(factors, PCCHOLESKY));
  petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
  petsc(EPSSetFromOptions(solver));
  return solver;
}

/// Tells a PartWatch, the context, how many eigenpairs there are. The search ends if any rank's says so.
PetscErrorCode tell_watch(EPS solver, PetscInt iterations, PetscInt most_iterations, PetscInt converged,
                          PetscInt wanted, EPSConvergedReason* reason, void* context) {
  PetscFunctionBeginUser;
  PetscCall(EPSStoppingBasic(solver, iterations, most_iterations, converged, wanted, reason, nullptr));
  if (converged > 0) {
    const bool goes_on = (*static_cast<const PartWatch*>(context))(std::min(converged, wanted), wanted);
    const bool all_go_on =
        parallel::smallest(goes_on ? 1 : 0, PetscObjectComm(reinterpret_cast<PetscObject>(solver))) == 1;
    if (*reason == EPS_CONVERGED_ITERATING && !all_go_on) {
      *reason = EPS_CONVERGED_USER;
    }
  }
  PetscFunctionReturn(0);
}

/// |A x - lambda M x| / |lambda M x| of an eigenpair, which does not depend on units or on the size of the body. With
/// A = K + shift M, modes far below the shift may have larger errors: slow motions on soft supports are not refused.
/// @param value  lambda, the shift included
double relative_residual(Mat matrix, Mat mass, PetscScalar value, Vec vector) {
  parallel::Handle<Vec> residual;
  parallel::Handle<Vec> inertia;
  petsc(VecDuplicate(vector, residual.out()));
  petsc(VecDuplicate(vector, inertia.out()));
  petsc(MatMult(matrix, vector, residual));
  petsc(MatMult(mass, vector, inertia));
  petsc(VecScale(inertia, value));
  petsc(VecAXPY(residual, -1.0, inertia));
  PetscReal left = 0.0;
  PetscReal whole = 0.0;
  petsc(VecNorm(residual, NORM_2, &left));
  petsc(VecNorm(inertia, NORM_2, &whole));
  return left / whole;
}

/// The eigenpairs closest to -shift beside what is known; fewer if the watch ends the search. Krylov-Schur from one
/// start vector finds the second and third mode of one frequency by rounding errors only, so it may miss them.
std::vector<Eigenpair> search(const EigenProblem& problem, const Known& known, int count, double shift,
                              PartWatch watch) {
  constexpr double largest_residual = 0.01;  // good vectors have some 1e-6, wrong ones about 1
  const parallel::Handle<Mat> shifted = shifted_matrix(problem, shift);
  const parallel::Handle<EPS> solver = create_solver(problem, shifted, count);
  std::vector<Vec> left_out(known.begin(), known.end());
  petsc(EPSSetDeflationSpace(solver, static_cast<PetscInt>(left_out.size()), left_out.data()));
  if (watch) {
    petsc(EPSSetStoppingTestFunction(solver, tell_watch, &watch, nullptr));
  }
  petsc(EPSSolve(solver));
  PetscInt converged = 0;
  EPSConvergedReason reason = EPS_CONVERGED_ITERATING;
  petsc(EPSGetConverged(solver, &converged));
  petsc(EPSGetConvergedReason(solver, &reason));
  if (converged < count && reason != EPS_CONVERGED_USER) {
    throw std::runtime_error(
        fmt::format("only {} of {} modes were found; ask for fewer, or give the solver more room, for instance "
                    "-modes_eps_ncv {}",
                    converged, count, 4 * count + 40));
  }
  parallel::Handle<Vec> vector;
  petsc(MatCreateVecs(problem.stiffness(), vector.out(), nullptr));
  std::vector<Eigenpair> pairs;
  for (PetscInt i = 0; i < std::min(converged, PetscInt{count}); ++i) {
    PetscScalar value = 0.0;
    petsc(EPSGetEigenpair(solver, i, &value, nullptr, vector, nullptr));
    const double error = relative_residual(shifted, problem.mass(), value, vector);
    value -= shift;
    if (!(value > 0) || !(error < largest_residual)) {
      throw std::runtime_error(
          fmt::format("a mode is wrong (eigenvalue {:.3g} 1/s2, relative residual {:.2g}): either a part of the body "
                      "hangs on by a line or a point, or the elements are so thin that rounding decides such a low "
                      "mode; then fewer elements through the thickness help, or an ideal plate (ideal_bodies)",
                      value, error));
    }
    pairs.push_back({value, problem.extended(vector)});
  }
  return pairs;
}

/// @throws std::runtime_error where the rigid motions strain the body nearly as much as its lowest mode, (rad/s)^2
void check_rigid(const EigenProblem& problem, const Known& rigid, double lowest) {
  parallel::Handle<Vec> image;
  petsc(MatCreateVecs(problem.stiffness(), nullptr, image.out()));
  double largest = 0.0;  // x^T K x/x^T M x
  for (const auto& vector : rigid) {
    PetscScalar stiffness = 0.0;
    PetscScalar mass = 0.0;
    petsc(MatMult(problem.stiffness(), vector, image));
    petsc(VecDot(vector, image, &stiffness));
    petsc(MatMult(problem.mass(), vector, image));
    petsc(VecDot(vector, image, &mass));
    largest = std::max(largest, std::abs(stiffness) / mass);
  }
  constexpr double negligible = 1e-3;
  if (largest > negligible * lowest) {
    throw std::runtime_error(fmt::format(
        "the body's rigid motions can't be told from its modes: they strain it as if at {:.3g} Hz, and the lowest mode "
        "is at {:.3g} Hz",
        std::sqrt(largest) / (2 * std::numbers::pi), std::sqrt(lowest) / (2 * std::numbers::pi)));
  }
}

/// Where to count modes: just below the last of ascending eigenvalues and those that equal it, (rad/s)^2.
double below_the_last(const std::vector<Eigenpair>& pairs) {
  constexpr double apart = 1e-6;  // far above rounding, far below what is heard
  auto last = pairs.end() - 1;
  while (last != pairs.begin() && (last - 1)->value > (1 - apart) * last->value) {
    --last;
  }
  return (1 - apart / 2) * last->value;
}

/// How many eigenpairs there should be, below what is known or just below the last one.
/// @param rigid  number of rigid motions
/// @param pairs  found so far, ascending
EigenpairCount complete_count(const EigenProblem& problem, std::size_t rigid, const std::vector<Eigenpair>& pairs,
                              const EigenpairCount& wanted) {
  if (wanted.below && std::ssize(pairs) == wanted.count && pairs.back().value < *wanted.below) {
    return wanted;
  }
  const double bound = below_the_last(pairs);
  return {static_cast<int>(eigenvalues_below(problem, bound)) - static_cast<int>(rigid), bound};
}

/// Searches for what is missing until there are as many eigenpairs below a bound as there should be.
/// @param known  rigid motions
/// @param pairs  found so far; sorted at the end
/// @param all    how many there should be
void complete(const EigenProblem& problem, Known& known, std::vector<Eigenpair>& pairs, double shift,
              const EigenpairCount& all) {
  constexpr int most_searches = 20;
  const auto [wanted, below] = all;
  const double bound = below.value();
  std::size_t known_pairs = 0;
  for (int searches = 0;; ++searches) {
    const auto found = std::ranges::count_if(pairs, [&](const Eigenpair& pair) { return pair.value < bound; });
    if (found == wanted) {
      break;
    }
    if (found > wanted || searches == most_searches) {
      throw std::runtime_error(fmt::format("{} modes were found below {:.6g} Hz, but there are {}", found,
                                           std::sqrt(bound) / (2 * std::numbers::pi), wanted));
    }
    for (; known_pairs < pairs.size(); ++known_pairs) {
      known.push_back(problem.restricted(pairs[known_pairs].vector));
    }
    std::ranges::move(search(problem, known, wanted - static_cast<int>(found), shift, {}), std::back_inserter(pairs));
  }
  std::ranges::sort(pairs, {}, &Eigenpair::value);
}

}  // namespace

std::vector<Eigenpair> lowest_eigenpairs(const EigenProblem& problem,
                                         const std::vector<std::vector<double>>& rigid_motions,
                                         const EigenpairCount& wanted, double shift, const PartWatch& watch) {
  Known known;
  for (const auto& motion : rigid_motions) {
    known.push_back(problem.restricted(motion));
  }
  std::vector<Eigenpair> pairs = search(problem, known, wanted.count, shift, watch);
  const std::size_t found = pairs.size();
  std::ranges::sort(pairs, {}, &Eigenpair::value);
  check_rigid(problem, known, pairs.front().value);
  complete(problem, known, pairs, shift, complete_count(problem, known.size(), pairs, wanted));
  pairs.resize(found);
  return pairs;
}

NoModes no_modes_up_to(double frequency, const std::string& body, const EigenProblem& problem,
                       const std::vector<std::vector<double>>& rigid_motions, double shift) {
  try {
    const double lowest = lowest_eigenpairs(problem, rigid_motions, {1}, shift).front().value;
    return {body, frequency, std::sqrt(lowest) / (2 * std::numbers::pi)};
  } catch (const std::runtime_error& error) {
    return {body, frequency, std::string(error.what())};
  }
}

}  // namespace idiophone::eigenmodes
