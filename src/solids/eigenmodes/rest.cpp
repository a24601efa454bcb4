#include "rest.hpp"

#include <fmt/format.h>
#include <petscksp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "with_ghosts.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;
using solid::NodeForce;
using solid::NodeState;

namespace {

/// The free components of an equilibrium, and one step of Newton's method.
class Newton {
 public:
  Newton(const mesh::Part& part, const motion::FiniteElementDynamics& dynamics, std::span<const double> support,
         const motion::Components& components, MPI_Comm communicator)
      : part_(part),
        dynamics_(dynamics),
        support_(support),
        components_(components),
        communicator_(communicator),
        tangent_(motion::create_matrix(part.bodies, components, motion::Coupling::of_all_axes, communicator,
                                       joints::coupled_nodes(dynamics.joints().all()))) {
    petsc(MatCreateVecs(tangent_, change_.out(), unbalanced_.out()));
    petsc(KSPCreate(communicator, solver_.out()));
    petsc(KSPSetType(solver_, KSPPREONLY));
    PC factors = nullptr;
    petsc(KSPGetPC(solver_, &factors));
    petsc(PCSetType(factors, PCLU));
    petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
  }

  /// Puts a state, [local nodes], to where the tangent there expects the equilibrium.
  /// @return norm of the forces that were out of balance, N
  double improve(std::vector<NodeState>& state) {
    find_unbalanced(state);
    petsc(MatZeroEntries(tangent_));
    for (std::size_t b = 0; b < part_.bodies.size(); ++b) {
      motion::add_tangent_stiffness(part_, part_.bodies[b], dynamics_.solid(b), &solid::Solid::relaxed_elasticity,
                                    state, components_, tangent_);
    }
    motion::add_joint_stiffness(dynamics_.joints(), state, components_, tangent_);
    for (std::size_t c = 0; c < 3 * support_.size(); ++c) {
      petsc(MatSetValue(tangent_, components_.number[c], components_.number[c], support_[c / 3], ADD_VALUES));
    }
    petsc(MatAssemblyBegin(tangent_, MAT_FINAL_ASSEMBLY));
    petsc(MatAssemblyEnd(tangent_, MAT_FINAL_ASSEMBLY));
    petsc(KSPSetOperators(solver_, tangent_, tangent_));
    petsc(KSPSolve(solver_, unbalanced_, change_));
    add_change(state);
    PetscReal norm = 0.0;
    petsc(VecNorm(unbalanced_, NORM_2, &norm));
    return norm;
  }

 private:
  void find_unbalanced(const std::vector<NodeState>& state) {
    std::vector<NodeForce> force(state.size());
    for (std::size_t b = 0; b < part_.bodies.size(); ++b) {
      dynamics_.solid(b).add_internal_force(state, force);
    }
    dynamics_.joints().add_force(state, force);
    PetscScalar* values = nullptr;
    petsc(VecGetArrayWrite(unbalanced_, &values));
    for (std::size_t c = 0; c < 3 * support_.size(); ++c) {
      if (components_.number[c] >= 0) {
        values[components_.number[c] - components_.begin] =
            force[c / 3].component[c % 3] - support_[c / 3] * state[c / 3].displacement[c % 3];
      }
    }
    petsc(VecRestoreArrayWrite(unbalanced_, &values));
  }

  void add_change(std::vector<NodeState>& state) const {
    const PetscScalar* values = nullptr;
    petsc(VecGetArrayRead(change_, &values));
    std::vector<double> moved(3 * support_.size());
    for (std::size_t c = 0; c < moved.size(); ++c) {
      moved[c] = state[c / 3].displacement[c % 3] +
                 (components_.number[c] >= 0 ? values[components_.number[c] - components_.begin] : 0.0);
    }
    petsc(VecRestoreArrayRead(change_, &values));
    const std::vector<double> all = with_ghosts(part_, moved, communicator_);
    for (std::size_t c = 0; c < all.size(); ++c) {
      state[c / 3].displacement[c % 3] = all[c];
    }
  }

  const mesh::Part& part_;
  const motion::FiniteElementDynamics& dynamics_;
  std::span<const double> support_;  ///< N/m, [owned nodes]
  const motion::Components& components_;
  MPI_Comm communicator_;
  parallel::Handle<Mat> tangent_;
  parallel::Handle<Vec> change_;      ///< m
  parallel::Handle<Vec> unbalanced_;  ///< N
  parallel::Handle<KSP> solver_;
};

}  // namespace

std::vector<NodeState> rest_under_prestress(const scene::Solids& solids, const mesh::Part& part,
                                            const motion::FiniteElementDynamics& dynamics,
                                            std::span<const char> deformed, std::span<const double> support,
                                            const motion::Components& components, MPI_Comm communicator) {
  std::vector<NodeState> state(part.node_ids.size());
  const scene::Body& body = solids.bodies[std::ranges::find(deformed, 1) - deformed.begin()];
  const auto refuse = [&](const std::string& why) {
    throw deck::DeckError(body.prestress->where, fmt::format("bodies.{}.prestress {}", body.name, why));
  };
  const std::int64_t held = std::ssize(dynamics.constraints().held_components()) +
                            std::ranges::count_if(support, [](double stiffness) { return stiffness > 0; });
  if (parallel::sum(held, communicator) < 6) {
    refuse("deforms a body that nothing holds: give it fixed groups or supports");
  }
  dynamics.constraints().place(0.0, state);
  Newton newton(part, dynamics, support, components, communicator);
  constexpr int most_steps = 50;
  constexpr double balanced = 1e-10;  // of the forces at the beginning
  const double begin = newton.improve(state);
  for (int step = 1; step < most_steps; ++step) {
    const double unbalanced = newton.improve(state);
    if (unbalanced <= balanced * begin) {
      return state;
    }
    if (!std::isfinite(unbalanced)) {
      break;
    }
  }
  refuse("leaves no static equilibrium that was found: is it too large, or does a joint let a body move freely?");
  return state;
}

}  // namespace idiophone::eigenmodes
