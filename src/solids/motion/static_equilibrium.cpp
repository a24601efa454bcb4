#include "static_equilibrium.hpp"

#include <fmt/format.h>
#include <petscsnes.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/motion/assembly.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// One body's balance of forces: unknowns are its nodes' displacements, [3 x nodes of the body].
class Equilibrium {
 public:
  Equilibrium(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
              const FiniteElementDynamics& dynamics, std::size_t body)
      : part_(part),
        body_(part.bodies[body]),
        material_(solids.materials[solids.bodies[body].material]),
        solid_(dynamics.solid(body)),
        support_(part.node_ids.size()),
        load_(3 * size_of(body_)),
        state_(part.node_ids.size()),
        force_(part.node_ids.size()) {
    components_.end = static_cast<PetscInt>(load_.size());
    components_.number.assign(3 * part.node_ids.size(), -1);
    const auto own = std::span(components_.number).subspan(3UL * body_.owned_begin, load_.size());
    std::iota(own.begin(), own.end(), 0);
    dynamics.loads().add_support_stiffness(support_);
    for (std::size_t node = 0; node < load_.size() / 3; ++node) {
      const double mass = dynamics.model(body).masses()[node];
      for (std::size_t i = 0; i < 3; ++i) {
        load_[3 * node + i] = mass * solids.gravity[i];
      }
    }
    for (std::size_t p = 0; p < solids.plucks.size(); ++p) {
      if (solids.plucks[p].body == body) {
        add_pluck(attachments.plucks[p], solids.plucks[p].force);
      }
    }
    dynamics.constraints().place(0.0, state_);
    for (const Index component : dynamics.constraints().held_components()) {
      if (component >= 3 * body_.owned_begin && component < 3 * body_.owned_end) {
        held_.push_back(component - 3 * body_.owned_begin);
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return load_.size(); }
  [[nodiscard]] bool is_held() const {
    return held_.size() >= 6 || std::ranges::any_of(support_, [](double stiffness) { return stiffness > 0; });
  }
  /// Euclidean norm of all nodes' loads, N.
  [[nodiscard]] double load_norm() const {
    return Eigen::Map<const Eigen::VectorXd>(load_.data(), std::ssize(load_)).norm();
  }
  void set_load_fraction(double fraction) { fraction_ = fraction; }

  /// Unbalanced force, N; for a held component, how far it is from its place, times a stiffness.
  void residual(std::span<const double> u, std::span<double> unbalanced) {
    const std::vector<NodeState> places = state_;
    set_displacements(u);
    std::ranges::fill(force_, NodeForce{});
    solid_.add_internal_force(state_, force_);
    for (std::size_t c = 0; c < size(); ++c) {
      const std::size_t node = body_.owned_begin + c / 3;
      unbalanced[c] = support_[node] * u[c] - force_[node].component[c % 3] - fraction_ * load_[c];
    }
    state_ = places;
    for (const Index c : held_) {
      const Index node = body_.owned_begin + c / 3;
      unbalanced[c] = stiffness_scale() * (u[c] - state_[node].displacement[c % 3]);
    }
  }

  /// Tangent stiffness at displacements u.
  void jacobian(std::span<const double> u, Mat matrix) const {
    petsc(MatZeroEntries(matrix));
    std::vector<Vector3> reference;
    std::vector<Vector3> displacement;
    const auto tangent = [&](std::size_t element) {
      reference.clear();
      displacement.clear();
      for (const Index node : body_.element_nodes(element)) {
        reference.push_back(part_.reference[node]);
        displacement.emplace_back(&u[3 * static_cast<std::size_t>(node - body_.owned_begin)]);
      }
      const auto region = static_cast<std::size_t>(body_.region(element));
      return solid::tangent_stiffness(body_.element, solid_.relaxed_elasticity(region), reference, displacement,
                                      solid_.initial_stress(region));
    };
    add_elements(body_, components_, tangent, matrix);
    for (std::size_t c = 0; c < size(); ++c) {
      const double stiffness = support_[body_.owned_begin + c / 3];
      petsc(MatSetValue(matrix, static_cast<PetscInt>(c), static_cast<PetscInt>(c), stiffness, ADD_VALUES));
    }
    petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    petsc(MatZeroRows(matrix, static_cast<PetscInt>(held_.size()), held_.data(), stiffness_scale(), nullptr, nullptr));
  }

  /// An empty tangent stiffness.
  [[nodiscard]] parallel::Handle<Mat> create_tangent() const {
    parallel::Handle<Mat> tangent = create_matrix(std::span(&body_, 1), components_, PETSC_COMM_SELF);
    petsc(MatSetOption(tangent, MAT_KEEP_NONZERO_PATTERN, PETSC_TRUE));
    return tangent;
  }

 private:
  static std::size_t size_of(const mesh::BodyPart& body) { return body.owned_end - body.owned_begin; }

  void add_pluck(const mesh::Patch& patch, const Vector3& force) {
    for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
      for (int i = 0; i < 3; ++i) {
        const Index component = 3 * (patch.nodes[n] - body_.owned_begin) + i;
        load_[component] += patch.shares[n] * force[i];
      }
    }
  }

  void set_displacements(std::span<const double> u) {
    for (std::size_t c = 0; c < size(); ++c) {
      state_[body_.owned_begin + c / 3].displacement[c % 3] = u[c];
    }
  }

  /// About the size of the stiffness matrix's diagonal, N/m.
  [[nodiscard]] double stiffness_scale() const {
    const auto& first = std::span(body_.elements);
    return material_.young * (part_.reference[first[0]] - part_.reference[first[1]]).norm();
  }

  const mesh::Part& part_;
  const mesh::BodyPart& body_;
  const scene::Material& material_;
  const solid::Solid& solid_;
  std::vector<double> support_;  ///< N/m, [nodes]
  std::vector<double> load_;     ///< N, [3 x nodes of the body]
  double fraction_ = 1.0;
  std::vector<NodeState> state_;  ///< constraints' places, [nodes]
  std::vector<NodeForce> force_;
  Components components_;
  std::vector<Index> held_;  ///< components held, [3 node of the body + axis]
};

PetscErrorCode form_residual(SNES /*solver*/, Vec displacement, Vec unbalanced, void* context) {
  PetscFunctionBegin;
  const PetscScalar* u = nullptr;
  PetscScalar* r = nullptr;
  PetscCall(VecGetArrayRead(displacement, &u));
  PetscCall(VecGetArrayWrite(unbalanced, &r));
  auto* problem = static_cast<Equilibrium*>(context);
  problem->residual({u, problem->size()}, {r, problem->size()});
  PetscCall(VecRestoreArrayWrite(unbalanced, &r));
  PetscCall(VecRestoreArrayRead(displacement, &u));
  PetscFunctionReturn(0);
}

PetscErrorCode form_jacobian(SNES /*solver*/, Vec displacement, Mat matrix, Mat /*preconditioner*/, void* context) {
  PetscFunctionBegin;
  const PetscScalar* u = nullptr;
  PetscCall(VecGetArrayRead(displacement, &u));
  const auto* problem = static_cast<const Equilibrium*>(context);
  problem->jacobian({u, problem->size()}, matrix);
  PetscCall(VecRestoreArrayRead(displacement, &u));
  PetscFunctionReturn(0);
}

/// Newton's method with MUMPS's factors, on this rank alone.
class NewtonSolver {
 public:
  explicit NewtonSolver(Equilibrium& problem) : problem_(problem) {
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
      problem_.set_load_fraction(static_cast<double>(increment) / increments);
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
  Equilibrium& problem_;
  parallel::Handle<Vec> displacement_;
  parallel::Handle<Vec> unbalanced_;
  parallel::Handle<Mat> tangent_;
  parallel::Handle<SNES> solver_;
};

}  // namespace

std::vector<double> static_equilibrium(const scene::Solids& solids, const mesh::Part& part,
                                       const Attachments& attachments, const FiniteElementDynamics& dynamics) {
  std::vector<double> displacement;
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    const auto pluck = std::ranges::find(solids.plucks, b, &scene::Pluck::body);
    if (pluck == solids.plucks.end()) {
      continue;
    }
    Equilibrium problem(solids, part, attachments, dynamics, b);
    if (!problem.is_held()) {
      throw deck::DeckError(
          pluck->place.where,
          fmt::format("body '{}' can't be plucked: nothing holds it; give it fixed groups or supports",
                      solids.bodies[b].name));
    }
    NewtonSolver newton(problem);
    const std::array increments = {1, 4, 16, 64};
    if (std::ranges::none_of(increments, [&](int count) { return newton.solve(count); })) {
      throw deck::DeckError(
          pluck->place.where,
          fmt::format(
              "no static equilibrium of body '{}' under pluck '{}' was found, not even in {} increments of the load; "
              "is the force too large, or is the body free to turn?",
              solids.bodies[b].name, pluck->name, increments.back()));
    }
    displacement.resize(3UL * part.global_nodes);
    newton.copy_to(std::span(displacement).subspan(3UL * part.bodies[b].owned_begin, problem.size()));
  }
  return displacement;
}

}  // namespace idiophone::motion
