#include "static_equilibrium.hpp"

#include <fmt/format.h>
#include <petscsnes.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "deforming_cause.hpp"
#include "force_balance.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/motion/prestress_balance.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

PetscErrorCode form_residual(SNES /*solver*/, Vec displacement, Vec unbalanced, void* context) {
  PetscFunctionBegin;
  const PetscScalar* u = nullptr;
  PetscScalar* r = nullptr;
  PetscCall(VecGetArrayRead(displacement, &u));
  PetscCall(VecGetArrayWrite(unbalanced, &r));
  auto* problem = static_cast<ForceBalance*>(context);
  problem->residual({u, problem->size()}, {r, problem->size()});
  PetscCall(VecRestoreArrayWrite(unbalanced, &r));
  PetscCall(VecRestoreArrayRead(displacement, &u));
  PetscFunctionReturn(0);
}

PetscErrorCode form_jacobian(SNES /*solver*/, Vec displacement, Mat matrix, Mat /*preconditioner*/, void* context) {
  PetscFunctionBegin;
  const PetscScalar* u = nullptr;
  PetscCall(VecGetArrayRead(displacement, &u));
  auto* problem = static_cast<ForceBalance*>(context);
  problem->jacobian({u, problem->size()}, matrix);
  PetscCall(VecRestoreArrayRead(displacement, &u));
  PetscFunctionReturn(0);
}

/// Newton's method with MUMPS's factors, on this rank alone.
class NewtonSolver {
 public:
  explicit NewtonSolver(ForceBalance& problem) : problem_(problem) {
    const auto size = static_cast<PetscInt>(problem.size());
    petsc(VecCreateSeq(PETSC_COMM_SELF, size, displacement_.out()));
    petsc(VecDuplicate(displacement_, unbalanced_.out()));
    tangent_ = problem.create_tangent();
    petsc(SNESCreate(PETSC_COMM_SELF, solver_.out()));
    petsc(SNESSetOptionsPrefix(solver_, "preload_"));
    petsc(SNESSetFunction(solver_, unbalanced_, form_residual, &problem));
    petsc(SNESSetJacobian(solver_, tangent_, tangent_, form_jacobian, &problem));
    petsc(SNESSetTolerances(solver_, 1e-9 * problem.load_norm(), 1e-10, 1e-12, 50, 10000));
    // Bending stretches a slender body at first: its unbalanced force may grow by any factor before it falls, and a
    // line search on it would punish that.
    petsc(SNESSetDivergenceTolerance(solver_, std::numeric_limits<double>::max()));  // -1 is the default since 3.22
    SNESLineSearch line_search = nullptr;
    petsc(SNESGetLineSearch(solver_, &line_search));
    petsc(SNESLineSearchSetType(line_search, SNESLINESEARCHBASIC));
    KSP linear = nullptr;
    PC factors = nullptr;
    petsc(SNESGetKSP(solver_, &linear));
    petsc(KSPSetType(linear, KSPPREONLY));
    petsc(KSPGetPC(linear, &factors));
    petsc(PCSetType(factors, PCLU));
    petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
    petsc(SNESSetFromOptions(solver_));
  }

  /// Whether equilibrium was reached in so many increments of the load from the undeformed body.
  bool solve(int increments) {
    petsc(VecZeroEntries(displacement_));
    for (int increment = 1; increment <= increments; ++increment) {
      problem_.set_fraction(static_cast<double>(increment) / increments);
      petsc(SNESSolve(solver_, nullptr, displacement_));
      SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
      petsc(SNESGetConvergedReason(solver_, &reason));
      if (reason < 0) {
        return false;
      }
    }
    return true;
  }

  void copy_to(std::span<double> target) const {
    const PetscScalar* u = nullptr;
    petsc(VecGetArrayRead(displacement_, &u));
    std::copy_n(u, target.size(), target.begin());
    petsc(VecRestoreArrayRead(displacement_, &u));
  }

 private:
  ForceBalance& problem_;
  parallel::Handle<Vec> displacement_;
  parallel::Handle<Vec> unbalanced_;
  parallel::Handle<Mat> tangent_;
  parallel::Handle<SNES> solver_;
};

bool is_plucked(const scene::Solids& solids, std::size_t body) {
  return std::ranges::find(solids.plucks, body, &scene::Pluck::body) != solids.plucks.end();
}

/// The names of bodies, for messages: 'string', 'bridge'.
std::string names_of(const scene::Solids& solids, const std::vector<std::size_t>& bodies) {
  std::string names;
  for (const std::size_t body : bodies) {
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", solids.bodies[body].name);
  }
  return (bodies.size() > 1 ? "bodies " : "body ") + names;
}

/// Displacements of the unknowns. @throws deck::DeckError, as static_equilibrium()
std::vector<double> solve(ForceBalance& problem, const std::string& bodies, const DeformingCause& cause) {
  if (!problem.is_held()) {
    throw deck::DeckError(cause.where, fmt::format("nothing holds {} under {}, so there is no rest: "
                                                   "give fixed groups or supports",
                                                   bodies, cause.what));
  }
  NewtonSolver newton(problem);
  const std::array increments = {1, 4, 16, 64};
  if (std::ranges::none_of(increments, [&](int count) { return newton.solve(count); })) {
    throw deck::DeckError(
        cause.where,
        fmt::format("no static equilibrium of {} under {} was found, not even in {} increments of the load; "
                    "is the force too large, or is a body free to turn?",
                    bodies, cause.what, increments.back()));
  }
  std::vector<double> displacement(problem.size());
  newton.copy_to(displacement);
  return displacement;
}

}  // namespace

std::vector<double> static_equilibrium(const scene::Solids& solids, const mesh::Part& part,
                                       const Attachments& attachments, const FiniteElementDynamics& dynamics) {
  const std::vector<char> deformed = deformed_by_prestress(solids, part, dynamics, MPI_COMM_SELF);
  std::vector<double> displacement;
  for (const std::vector<std::size_t>& bodies : scene::assemblies(solids)) {
    const std::optional<DeformingCause> cause = deforming_cause(solids, bodies, deformed);
    if (!cause) {
      continue;
    }
    const std::size_t first = bodies.front();
    const bool is_modal_alone = solids.bodies[first].modal.has_value() && !scene::is_joined(first, solids.joints);
    if (is_modal_alone && !is_plucked(solids, first)) {
      continue;
    }
    const std::string names = names_of(solids, bodies);
    ForceBalance problem(solids, part, attachments, dynamics, bodies, true);
    std::vector<double> u = solve(problem, names, *cause);
    if (is_modal_alone && deformed[first] != 0) {  // its modes move it about where its prestress leaves it
      ForceBalance unloaded(solids, part, attachments, dynamics, bodies, false);
      std::ranges::transform(u, solve(unloaded, names, *cause), u.begin(), std::minus());
    }
    displacement.resize(3UL * part.global_nodes);
    for (std::size_t c = 0; c < u.size(); ++c) {
      displacement[problem.places_of_unknowns()[c]] = u[c];
    }
  }
  return displacement;
}

}  // namespace idiophone::motion
