#include "refined_problem.hpp"

#include <algorithm>
#include <iterator>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/joints/refined_joints.hpp"
#include "rigid_motions.hpp"
#include "shifted_matrix.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

/// The assembly of the first body, which has all bodies of the solids, with the elements of the meshes.
/// @param joints  of the given meshes, whose reach these joints get
scene::Assembly assembly_on(const scene::Solids& solids, std::span<const mesh::Mesh> meshes,
                            std::span<const joints::MeshedJoint> joints) {
  scene::Assembly assembly(solids, 0);
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    assembly.bodies[b].element = meshes[b].element;
  }
  for (const joints::MeshedJoint& meshed : joints) {
    assembly.joints[meshed.joint].reach = meshed.reach;
  }
  return assembly;
}

/// @param solids  on the refined meshes
motion::Attachments attached(const scene::Solids& solids, const MeshedBodies& given,
                             const std::vector<mesh::Mesh>& meshes, const std::vector<mesh::RefinedMesh>& refined,
                             const std::vector<mesh::Mesh>& of_refined) {
  const joints::HeldParts held = joints::held_parts(given.solids, meshes);
  motion::Attachments attachments =
      motion::attach(solids, of_refined, joints::refined(held, given.solids, meshes, refined));
  joints::act_as(given.attachments.joints, solids, meshes, refined, attachments.joints);
  return attachments;
}

std::vector<mesh::RefinedMesh> all_refined(std::span<const mesh::Mesh> meshes) {
  std::vector<mesh::RefinedMesh> refined;
  std::ranges::transform(meshes, std::back_inserter(refined), mesh::refined);
  return refined;
}

std::vector<mesh::Mesh> meshes_of(std::span<const mesh::RefinedMesh> refined) {
  std::vector<mesh::Mesh> meshes;
  std::ranges::transform(refined, std::back_inserter(meshes), &mesh::RefinedMesh::mesh);
  return meshes;
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

MeshedBodies::MeshedBodies(const scene::Solids& all, const std::vector<mesh::Mesh>& meshes, MassMatrix mass)
    : assembly(assembly_on(all, meshes, {})),
      solids(assembly.solids()),
      part(mesh::distribute(meshes, MPI_COMM_SELF)),
      attachments(motion::attach(solids, meshes)),
      operators(solids, part, attachments, mass, MPI_COMM_SELF) {}

MeshedBodies::MeshedBodies(const MeshedBodies& given, const std::vector<mesh::Mesh>& meshes,
                           const std::vector<mesh::RefinedMesh>& refined, MassMatrix mass)
    : MeshedBodies(given, meshes, refined, meshes_of(refined), mass) {}

MeshedBodies::MeshedBodies(const MeshedBodies& given, const std::vector<mesh::Mesh>& meshes,
                           const std::vector<mesh::RefinedMesh>& refined, const std::vector<mesh::Mesh>& of_refined,
                           MassMatrix mass)
    : assembly(assembly_on(given.solids, of_refined, given.attachments.joints)),
      solids(assembly.solids()),
      part(mesh::distribute(of_refined, MPI_COMM_SELF)),
      attachments(attached(solids, given, meshes, refined, of_refined)),
      operators(solids, part, attachments, mass, MPI_COMM_SELF) {}

RefinedProblem::RefinedProblem(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                               std::span<const double> lowest)
    : RefinedProblem(solids, meshes, all_refined(meshes), mass, lowest) {}

RefinedProblem::RefinedProblem(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                               const std::vector<mesh::RefinedMesh>& refined, MassMatrix mass,
                               std::span<const double> lowest)
    : given_(solids, meshes, mass), refined_(given_, meshes, refined, refined_mass(meshes.front().element, mass)) {
  connect(refined);
  set_up_cycle(given_value(lowest));
}

void RefinedProblem::connect(const std::vector<mesh::RefinedMesh>& refined) {
  const Operators& from = given_.operators;
  const Operators& to = refined_.operators;
  std::vector<PetscInt> lengths;
  const auto for_each_row = [&](auto visit) {
    std::size_t component = 0;
    for (std::size_t body = 0; body < refined.size(); ++body) {
      const Index first = given_.part.bodies[body].owned_begin;
      for (const std::vector<mesh::Parent>& parents : refined[body].parents) {
        for (std::size_t axis = 0; axis < 3; ++axis, ++component) {
          if (to.is_free(component)) {
            visit(to.number(component), parents, 3UL * first + axis);
          }
        }
      }
    }
  };
  for_each_row(
      [&](PetscInt, const auto& parents, std::size_t) { lengths.push_back(static_cast<PetscInt>(parents.size())); });
  petsc(MatCreateSeqAIJ(PETSC_COMM_SELF, to.size(), from.size(), 0, lengths.data(), interpolation_.out()));
  for_each_row([&](PetscInt row, const auto& parents, std::size_t first) {
    for (const mesh::Parent& parent : parents) {
      const PetscInt column = from.number(first + 3 * static_cast<std::size_t>(parent.node));  // -1 is left out
      petsc(MatSetValues(interpolation_, 1, &row, 1, &column, &parent.weight, INSERT_VALUES));
    }
  });
  petsc(MatAssemblyBegin(interpolation_, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(interpolation_, MAT_FINAL_ASSEMBLY));
}

void RefinedProblem::set_up_cycle(double shift) {
  coarse_ = shifted_matrix(given_.operators, shift);
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
