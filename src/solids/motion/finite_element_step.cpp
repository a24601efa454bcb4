// The largest stable step of a body of finite elements.

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "finite_element_body.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// y = L^T K L x for one body, with L L^T = M^-1 (solid::Mass) and held components left out; at rest Kelvin-Voigt's
/// damping force gives K x exactly.
struct BodyOperator {
  const mesh::BodyPart& body;
  const solid::Solid& solid;
  const solid::Mass& mass;
  std::span<const char> held;         ///< 1 where a component is held, [3 x owned nodes of the body]
  std::span<const double> stiffness;  ///< of supports, [owned nodes of all bodies]
  std::vector<NodeState> state;
  std::vector<NodeForce> force;

  [[nodiscard]] std::size_t size() const { return held.size(); }
  [[nodiscard]] NodeState& node(std::size_t component) { return state[body.owned_begin + component / 3]; }

  /// L x, zero where it is held.
  [[nodiscard]] std::vector<double> displacements(std::span<const double> x) const {
    std::vector<double> moved(x.begin(), x.end());
    mass.apply_inverse_factor(moved);
    leave_out_held(moved);
    return moved;
  }

  void apply(std::span<const double> x, std::span<double> result) {
    const std::vector<double> moved = displacements(x);
    for (std::size_t c = 0; c < size(); ++c) {
      node(c).velocity[c % 3] = moved[c];
    }
    std::ranges::fill(force, NodeForce{});
    solid.add_linear_stiffness_force(state, force);
    for (std::size_t c = 0; c < size(); ++c) {
      const std::size_t node = body.owned_begin + c / 3;
      result[c] = stiffness[node] * state[node].velocity[c % 3] - force[node].component[c % 3];
    }
    leave_out_held(result);
    mass.apply_transposed_inverse_factor(result);
  }

 private:
  void leave_out_held(std::span<double> values) const {
    for (std::size_t c = 0; c < size(); ++c) {
      values[c] = held[c] != 0 ? 0.0 : values[c];
    }
  }
};

PetscErrorCode apply_operator(Mat matrix, Vec in, Vec out) {
  PetscFunctionBegin;
  BodyOperator* body = nullptr;
  PetscCall(MatShellGetContext(matrix, static_cast<void*>(&body)));
  const PetscScalar* x = nullptr;
  PetscScalar* y = nullptr;
  PetscCall(VecGetArrayRead(in, &x));
  PetscCall(VecGetArrayWrite(out, &y));
  body->apply({x, body->size()}, {y, body->size()});
  PetscCall(VecRestoreArrayWrite(out, &y));
  PetscCall(VecRestoreArrayRead(in, &x));
  PetscFunctionReturn(0);
}

/// The largest eigenvalue (w^2) and its vector, by SLEPc's Krylov-Schur method on this rank alone.
double largest_eigenvalue(BodyOperator& body, std::vector<double>& vector) {
  const auto size = static_cast<PetscInt>(body.size());
  parallel::Handle<Mat> matrix;
  petsc(MatCreateShell(PETSC_COMM_SELF, size, size, size, size, &body, matrix.out()));
  petsc(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(apply_operator)));
  parallel::Handle<EPS> solver;
  petsc(EPSCreate(PETSC_COMM_SELF, solver.out()));
  petsc(EPSSetOptionsPrefix(solver, "stable_step_"));
  petsc(EPSSetOperators(solver, matrix, nullptr));
  petsc(EPSSetProblemType(solver, EPS_HEP));
  petsc(EPSSetWhichEigenpairs(solver, EPS_LARGEST_REAL));
  petsc(EPSSetTolerances(solver, 1e-3, 1000));  // far inside the safety factor
  petsc(EPSSetFromOptions(solver));
  petsc(EPSSolve(solver));
  PetscInt converged = 0;
  petsc(EPSGetConverged(solver, &converged));
  if (converged < 1) {
    throw std::runtime_error(
        "the largest eigenfrequency was not found, so no stable step is known; set time.steps_per_sample yourself");
  }
  parallel::Handle<Vec> mode;
  PetscScalar value = 0.0;
  petsc(MatCreateVecs(matrix, mode.out(), nullptr));
  petsc(EPSGetEigenpair(solver, 0, &value, nullptr, mode, nullptr));
  const PetscScalar* entries = nullptr;
  petsc(VecGetArrayRead(mode, &entries));
  vector.assign(entries, entries + size);
  petsc(VecRestoreArrayRead(mode, &entries));
  return value;
}

/// Place in `body` of the element that holds most energy of a mode of L^T K L.
std::size_t most_strained_element(BodyOperator& body, const std::vector<double>& mode) {
  constexpr double small = 1e-12;  // displacements so small that the strain is linear
  const std::vector<double> moved = body.displacements(mode);
  const double largest = std::abs(*std::ranges::max_element(moved, {}, [](double u) { return std::abs(u); }));
  body.state.assign(body.state.size(), NodeState{});
  std::vector<double> energy(body.body.element_ids.size());
  const auto add_energy = [&](double factor) {
    for (std::size_t c = 0; c < moved.size(); ++c) {
      body.node(c).displacement[c % 3] = moved[c] * factor;
    }
    std::vector<double> stored(energy.size());
    body.solid.elastic_energy(body.state, stored);
    std::ranges::transform(energy, stored, energy.begin(), std::plus());
  };
  add_energy(small / largest);
  if (body.solid.is_prestressed()) {
    add_energy(-small / largest);  // without the work of the prestress on the first order of strain
  }
  return std::ranges::max_element(energy) - energy.begin();
}

/// 1 where a component is held. [3 x owned nodes of the body]
std::vector<char> held_flags(const mesh::BodyPart& body, std::span<const Index> held) {
  std::vector<char> flags(3 * static_cast<std::size_t>(body.owned_end - body.owned_begin));
  for (const Index component : held) {
    flags[component - 3 * body.owned_begin] = 1;
  }
  return flags;
}

Vector3 element_centre(const mesh::BodyPart& body, std::size_t element, const std::vector<Vector3>& reference) {
  const std::vector<int>& corners = element::reference(body.element).corners;
  Vector3 centre = Vector3::Zero();
  for (const int corner : corners) {
    centre += reference[body.element_nodes(element)[corner]] / static_cast<double>(corners.size());
  }
  return centre;
}

}  // namespace

StableStep FiniteElementBody::stable_step(const Supports& supports) const {
  StableStep result;
  result.highest_loss = highest_loss_;
  const std::vector<char> held = held_flags(body_, constraints_.held_components(number_));
  if (std::ranges::all_of(held, [](char flag) { return flag != 0; })) {
    return result;
  }
  BodyOperator whole{.body = body_,
                     .solid = solid_,
                     .mass = mass_,
                     .held = held,
                     .stiffness = supports.stiffness,
                     .state = std::vector<NodeState>(part_.node_ids.size()),
                     .force = std::vector<NodeForce>(part_.node_ids.size())};
  std::vector<double> mode;
  const double square = largest_eigenvalue(whole, mode) * (1 + solid_.geometric_share());
  const double w = result.largest_frequency = std::sqrt(square);
  double rate = 0.0;  // largest c/m of the dashpots, 1/s
  for (Index node = body_.owned_begin; node < body_.owned_end; ++node) {
    rate = std::max(rate, supports.damping[node] / mass_.lumped(node));
  }
  result.damping = mass_damping_ + rate + solid_.damping(w);
  result.step = largest_step(w, result.damping);
  const std::size_t element = most_strained_element(whole, mode);
  result.element = body_.element_ids[element];
  result.centre = element_centre(body_, element, part_.reference);
  return result;
}

}  // namespace idiophone::motion
