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

#include "force_balance.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
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

/// Why and where a body has an equilibrium of its own, for messages.
struct Cause {
  std::string what;  ///< "pluck 'finger'"
  deck::Location where;
};

/// None: it rests undeformed.
std::optional<Cause> cause_of(const scene::Solids& solids, std::size_t body, bool is_deformed) {
  const auto pluck = std::ranges::find(solids.plucks, body, &scene::Pluck::body);
  if (pluck != solids.plucks.end()) {
    return Cause{fmt::format("pluck '{}'", pluck->name), pluck->place.where};
  }
  return is_deformed ? std::optional(Cause{"its prestress", solids.bodies[body].prestress->where}) : std::nullopt;
}

/// @throws deck::DeckError where joints tie a body that its prestress deforms to others: they are left out here
void refuse_joints(const scene::Solids& solids, std::size_t body) {
  const auto ties = [body](const scene::Joint& joint) {
    return std::ranges::any_of(joint.surfaces, [body](const auto& surface) { return surface.body == body; });
  };
  if (const auto joint = std::ranges::find_if(solids.joints, ties); joint != solids.joints.end()) {
    throw deck::DeckError(
        solids.bodies[body].prestress->where,
        fmt::format("the prestress deforms body '{}', which the joint '{}' holds: this is not possible "
                    "yet; leave out one of the two",
                    solids.bodies[body].name, joint->name));
  }
}

/// Displacements of the body's nodes. @throws deck::DeckError, as static_equilibrium()
std::vector<double> solve(ForceBalance problem, const std::string& body, const Cause& cause) {
  if (!problem.is_held()) {
    throw deck::DeckError(cause.where, fmt::format("body '{}' has no rest under {}: nothing holds it; give it fixed "
                                                   "groups or supports",
                                                   body, cause.what));
  }
  NewtonSolver newton(problem);
  const std::array increments = {1, 4, 16, 64};
  if (std::ranges::none_of(increments, [&](int count) { return newton.solve(count); })) {
    throw deck::DeckError(
        cause.where,
        fmt::format("no static equilibrium of body '{}' under {} was found, not even in {} increments of the load; "
                    "is the force too large, or is the body free to turn?",
                    body, cause.what, increments.back()));
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
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    const scene::Body& body = solids.bodies[b];
    const bool is_plucked = std::ranges::find(solids.plucks, b, &scene::Pluck::body) != solids.plucks.end();
    const std::optional<Cause> cause = cause_of(solids, b, deformed[b] != 0);
    if (deformed[b] != 0) {
      refuse_joints(solids, b);
    }
    if (!cause || (body.modal && !is_plucked)) {
      continue;
    }
    std::vector<double> u = solve({solids, part, attachments, dynamics, b, true}, body.name, *cause);
    if (body.modal && deformed[b] != 0) {  // its modes move it about where its prestress leaves it
      const std::vector<double> rest = solve({solids, part, attachments, dynamics, b, false}, body.name, *cause);
      std::ranges::transform(u, rest, u.begin(), std::minus());
    }
    displacement.resize(3UL * part.global_nodes);
    std::ranges::copy(u, displacement.begin() + 3L * part.bodies[b].owned_begin);
  }
  return displacement;
}

}  // namespace idiophone::motion
