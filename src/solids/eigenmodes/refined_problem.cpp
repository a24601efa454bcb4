#include "refined_problem.hpp"

#include <utility>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "rigid_motions.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

scene::Body with_element(scene::Body body, element::Type element) {
  body.element = element;
  return body;
}

scene::Solids of_one_body(scene::Solids solids, const scene::Body& body) {
  solids = solids.alone(0);
  solids.bodies = {&body, 1};
  return solids;
}

/// Refined tetrahedra have the consistent mass: its error is the smaller one, and always above zero. Hexahedra keep
/// theirs, as the errors of their lumped mass and of their quadrature cancel.
MassMatrix refined_mass(element::Type type, MassMatrix mass) {
  switch (type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return MassMatrix::consistent;
    case element::Kind::hex:
      return mass;
  }
  element::unknown_kind();
}

/// One sweep of Gauss and Seidel.
void set_sweep(KSP smoother, MatSORType direction) {
  PC sweep = nullptr;
  petsc(KSPSetType(smoother, KSPRICHARDSON));
  petsc(KSPSetNormType(smoother, KSP_NORM_NONE));
  petsc(KSPGetPC(smoother, &sweep));
  petsc(PCSetType(sweep, PCSOR));
  petsc(PCSORSetSymmetric(sweep, direction));
}

}  // namespace

MeshedBody::MeshedBody(const scene::Solids& all, mesh::Mesh mesh, MassMatrix mass)
    : body(with_element(all.bodies.front(), mesh.element)),
      solids(of_one_body(all, body)),
      part(mesh::distribute({mesh}, MPI_COMM_SELF)),
      attachments(motion::attach(solids, {mesh})),
      operators(solids, part, attachments, mass, MPI_COMM_SELF) {}

RefinedProblem::RefinedProblem(const scene::Solids& solids, const mesh::Mesh& mesh, MassMatrix mass,
                               std::span<const double> lowest)
    : RefinedProblem(solids, mesh, mesh::refined(mesh), mass, lowest) {}

RefinedProblem::RefinedProblem(const scene::Solids& solids, const mesh::Mesh& mesh, const mesh::RefinedMesh& refined,
                               MassMatrix mass, std::span<const double> lowest)
    : given_(solids, mesh, mass), refined_(solids, refined.mesh, refined_mass(mesh.element, mass)) {
  connect(refined);
  set_up_cycle(given_value(lowest));
}

void RefinedProblem::connect(const mesh::RefinedMesh& refined) {
  const Operators& from = given_.operators;
  const Operators& to = refined_.operators;
  std::vector<PetscInt> lengths;
  const auto for_each_row = [&](auto visit) {
    for (std::size_t c = 0; c < 3 * refined.parents.size(); ++c) {
      if (to.is_free(c)) {
        visit(to.number(c), refined.parents[c / 3], c % 3);
      }
    }
  };
  for_each_row(
      [&](PetscInt, const auto& parents, std::size_t) { lengths.push_back(static_cast<PetscInt>(parents.size())); });
  petsc(MatCreateSeqAIJ(PETSC_COMM_SELF, to.size(), from.size(), 0, lengths.data(), interpolation_.out()));
  for_each_row([&](PetscInt row, const auto& parents, std::size_t axis) {
    for (const mesh::Parent& parent : parents) {
      const PetscInt column = from.number(3 * static_cast<std::size_t>(parent.node) + axis);  // -1 is left out
      petsc(MatSetValues(interpolation_, 1, &row, 1, &column, &parent.weight, INSERT_VALUES));
    }
  });
  petsc(MatAssemblyBegin(interpolation_, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(interpolation_, MAT_FINAL_ASSEMBLY));
}

void RefinedProblem::set_up_cycle(double shift) {
  petsc(MatDuplicate(given_.operators.stiffness(), MAT_COPY_VALUES, coarse_.out()));
  petsc(MatAXPY(coarse_, shift, given_.operators.mass(), SUBSET_NONZERO_PATTERN));
  petsc(MatSetOption(coarse_, MAT_SYMMETRIC, PETSC_TRUE));
  petsc(PCCreate(PETSC_COMM_SELF, cycle_.out()));
  petsc(PCSetOptionsPrefix(cycle_, "estimate_"));
  petsc(PCSetOperators(cycle_, stiffness(), stiffness()));
  petsc(PCSetType(cycle_, PCMG));
  petsc(PCMGSetLevels(cycle_, 2, nullptr));
  petsc(PCMGSetInterpolation(cycle_, 1, interpolation_));
  KSP before = nullptr;
  KSP after = nullptr;
  KSP coarse = nullptr;
  PC factors = nullptr;
  petsc(PCMGGetSmootherDown(cycle_, 1, &before));
  petsc(PCMGGetSmootherUp(cycle_, 1, &after));
  set_sweep(before, SOR_LOCAL_FORWARD_SWEEP);
  set_sweep(after, SOR_LOCAL_BACKWARD_SWEEP);
  petsc(PCMGSetNumberSmooth(cycle_, 1));
  petsc(PCMGGetCoarseSolve(cycle_, &coarse));
  petsc(KSPSetOperators(coarse, coarse_, coarse_));
  petsc(KSPSetType(coarse, KSPPREONLY));
  petsc(KSPGetPC(coarse, &factors));
  petsc(PCSetType(factors, PCCHOLESKY));
  petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
  petsc(PCSetFromOptions(cycle_));
  petsc(PCSetUp(cycle_));
}

double RefinedProblem::given_value(std::span<const double> shape) const {
  const parallel::Handle<Vec> x = given_.operators.restricted({shape.begin(), shape.end()});
  parallel::Handle<Vec> image;
  petsc(VecDuplicate(x, image.out()));
  double stiffness = 0.0;
  double mass = 0.0;
  petsc(MatMult(given_.operators.stiffness(), x, image));
  petsc(VecDot(x, image, &stiffness));
  petsc(MatMult(given_.operators.mass(), x, image));
  petsc(VecDot(x, image, &mass));
  return stiffness / mass;
}

Eigen::MatrixXd RefinedProblem::rigid_motions() const {
  const auto motions = eigenmodes::rigid_motions(refined_.part, refined_.operators, PETSC_COMM_SELF);
  Eigen::MatrixXd vectors(size(), motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    for (std::size_t c = 0; c < motions[i].size(); ++c) {
      if (refined_.operators.is_free(c)) {
        vectors(refined_.operators.number(c), static_cast<Eigen::Index>(i)) = motions[i][c];
      }
    }
  }
  return vectors;
}

void RefinedProblem::interpolate(std::span<const double> shape, Vec interpolated) const {
  const parallel::Handle<Vec> x = given_.operators.restricted({shape.begin(), shape.end()});
  petsc(MatMult(interpolation_, x, interpolated));
}

void RefinedProblem::precondition(Vec force, Vec displacement) const {
  petsc(PCApply(cycle_, force, displacement));
}

}  // namespace idiophone::eigenmodes
