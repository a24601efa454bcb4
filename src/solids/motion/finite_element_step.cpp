// The largest stable step of a body of finite elements.

#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "body_operator.hpp"
#include "finite_element_body.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

PetscErrorCode apply_operator(Mat matrix, Vec in, Vec out) {
  PetscFunctionBegin;
  SharedOperator* shared = nullptr;
  PetscCall(MatShellGetContext(matrix, static_cast<void*>(&shared)));
  const PetscScalar* x = nullptr;
  PetscScalar* y = nullptr;
  PetscCall(VecGetArrayRead(in, &x));
  PetscCall(VecGetArrayWrite(out, &y));
  shared->apply({x, shared->size()}, {y, shared->size()});
  PetscCall(VecRestoreArrayWrite(out, &y));
  PetscCall(VecRestoreArrayRead(in, &x));
  PetscFunctionReturn(0);
}

/// How many vectors the search keeps. Most of the memory is theirs, so large bodies have 8 instead of SLEPc's 16, and
/// about 1.6 times as many products with the matrix.
PetscInt kept_vectors(PetscInt components) {
  constexpr PetscInt many = 15'000'000;
  return components < many ? PETSC_DEFAULT : 8;
}

/// The largest eigenvalue (w^2) and its vector, by SLEPc's Krylov-Schur method, which rank 0 runs alone, so that its
/// sums do not depend on the number of ranks.
double largest_eigenvalue(SharedOperator& shared, std::vector<double>& vector) {
  const auto size = static_cast<PetscInt>(shared.size());
  parallel::Handle<Mat> matrix;
  petsc(MatCreateShell(PETSC_COMM_SELF, size, size, size, size, &shared, matrix.out()));
  petsc(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(apply_operator)));
  parallel::Handle<EPS> solver;
  petsc(EPSCreate(PETSC_COMM_SELF, solver.out()));
  petsc(EPSSetOptionsPrefix(solver, "stable_step_"));
  petsc(EPSSetOperators(solver, matrix, nullptr));
  petsc(EPSSetProblemType(solver, EPS_HEP));
  petsc(EPSSetWhichEigenpairs(solver, EPS_LARGEST_REAL));
  petsc(EPSSetDimensions(solver, 1, kept_vectors(size), PETSC_DEFAULT));
  petsc(EPSSetTolerances(solver, 1e-3, 1000));  // far inside the safety factor
  petsc(EPSSetFromOptions(solver));
  petsc(EPSSolve(solver));
  PetscInt converged = 0;
  petsc(EPSGetConverged(solver, &converged));
  if (converged < 1) {
    throw std::runtime_error(
        "the largest eigenfrequency was not found, so no stable step is known; set time.steps_per_sample yourself");
  }
  vector.resize(shared.size());
  parallel::Handle<Vec> mode;
  petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size, vector.data(), mode.out()));
  PetscScalar value = 0.0;
  petsc(EPSGetEigenpair(solver, 0, &value, nullptr, mode, nullptr));
  return value;
}

/// The largest eigenvalue, on all ranks. Collective.
/// @param mode  set to its vector at this rank's nodes, [3 x owned nodes of the body]
double find_largest_eigenvalue(BodyOperator& own, const BodyRows& rows, MPI_Comm communicator,
                               std::vector<double>& mode) {
  double square = 0.0;
  std::vector<double> whole;  // on rank 0
  {
    SharedOperator shared(own, rows, communicator);
    shared.help();
    parallel::on_root(communicator, [&] {
      const SharedOperator::End end(shared);
      square = largest_eigenvalue(shared, whole);
    });
  }
  mode.resize(own.size());
  rows.scatter(whole, mode);
  return parallel::from_root(square, communicator);
}

/// An element, and the energy of a mode in it.
struct StrainedElement {
  double energy = -std::numeric_limits<double>::infinity();
  Index element = 0;                 ///< global number
  Vector3 centre = Vector3::Zero();  ///< m
};

/// Energy of a mode of L^T K L in the elements computed here. Collective.
/// @param moved  the mode, [3 x owned nodes of the body]
std::vector<double> energies(BodyOperator& body, std::vector<double> moved, MPI_Comm communicator) {
  constexpr double small = 1e-12;  // displacements so small that the strain is linear
  body.apply_factor(moved);
  double here = 0.0;
  std::ranges::for_each(moved, [&](double u) { here = std::max(here, std::abs(u)); });
  const double largest = parallel::largest(here, communicator);
  std::vector<double> energy(body.body.element_ids.size());
  const auto add_energy = [&](double factor) {
    body.displace(moved, factor);
    std::vector<double> stored(energy.size());
    body.solid.elastic_energy(body.state, stored);
    std::ranges::transform(energy, stored, energy.begin(), std::plus());
  };
  add_energy(small / largest);
  if (body.solid.is_prestressed()) {
    add_energy(-small / largest);  // without the work of the prestress on the first order of strain
  }
  return energy;
}

Vector3 element_centre(const mesh::BodyPart& body, std::size_t element, const std::vector<Vector3>& reference) {
  const std::vector<int>& corners = element::reference(body.element).corners;
  Vector3 centre = Vector3::Zero();
  for (const int corner : corners) {
    centre += reference[body.element_nodes(element)[corner]] / static_cast<double>(corners.size());
  }
  return centre;
}

/// The element with the largest of the energies, on any rank; the first one if there are several. Collective.
StrainedElement most_strained_element(const mesh::BodyPart& body, const std::vector<double>& energy,
                                      const std::vector<Vector3>& reference, MPI_Comm communicator) {
  StrainedElement most;
  for (std::size_t element = 0; element < energy.size(); ++element) {
    if (body.owned[element] != 0 && energy[element] > most.energy) {
      most = {energy[element], body.element_ids[element], element_centre(body, element, reference)};
    }
  }
  for (const StrainedElement& other : parallel::gather(most, communicator)) {
    if (other.energy > most.energy || (other.energy == most.energy && other.element < most.element)) {
      most = other;
    }
  }
  return most;
}

/// 1 where a component is held. [3 x owned nodes of the body]
std::vector<char> held_flags(const mesh::BodyPart& body, std::span<const Index> held) {
  std::vector<char> flags(3 * static_cast<std::size_t>(body.owned_end - body.owned_begin));
  for (const Index component : held) {
    flags[component - 3 * body.owned_begin] = 1;
  }
  return flags;
}

}  // namespace

StableStep FiniteElementBody::stable_step(const Supports& supports, const BodyRanks& ranks) const {
  StableStep result;
  result.highest_loss = highest_loss_;
  const std::vector<char> held = held_flags(body_, constraints_.held_components(number_));
  const auto free = static_cast<std::int32_t>(std::ranges::count(held, 0) > 0);
  if (parallel::largest(free, ranks.communicator) == 0) {
    return result;
  }
  BodyOperator own{.part = part_,
                   .body = body_,
                   .solid = solid_,
                   .mass = mass_,
                   .held = held,
                   .stiffness = supports.stiffness,
                   .ghosts = ranks.ghosts,
                   .state = std::vector<NodeState>(part_.node_ids.size()),
                   .force = std::vector<NodeForce>(part_.node_ids.size())};
  std::vector<double> mode;
  const double square =
      find_largest_eigenvalue(own, BodyRows(part_, body_, 3, ranks.communicator), ranks.communicator, mode) *
      (1 + solid_.geometric_share());
  const double w = result.largest_frequency = std::sqrt(square);
  double rate = 0.0;  // largest c/m of the dashpots, 1/s
  for (Index node = body_.owned_begin; node < body_.owned_end; ++node) {
    rate = std::max(rate, supports.damping[node] / mass_.lumped(node));
  }
  result.damping = mass_damping_ + parallel::largest(rate, ranks.communicator) + solid_.damping(w);
  result.step = largest_step(w, result.damping);
  const StrainedElement most = most_strained_element(body_, energies(own, std::move(mode), ranks.communicator),
                                                     part_.reference, ranks.communicator);
  result.element = most.element;
  result.centre = most.centre;
  return result;
}

}  // namespace idiophone::motion
