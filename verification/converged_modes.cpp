// converged_modes DECK COUNT [KEY=VALUE ...]: the lowest eigenfrequencies (Hz) of a deck's first body as it is held
// there, without a step in time, a filter or a sound: what a mesh gives, and, refined, what 3-D elasticity gives.

#include <fmt/core.h>
#include <slepceps.h>

#include <cmath>
#include <numbers>

#include "idiophone/mesh/mesh.hpp"
#include "idiophone/mesh/part.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solid/solid.hpp"
#include "idiophone/solid/tangent_stiffness.hpp"

namespace {

using namespace idiophone;

/// Number of each component (3 node + axis) among the free ones, or -1 where it is held. [3 x nodes]
struct Unknowns {
  std::vector<PetscInt> number;
  PetscInt count = 0;

  Unknowns(const scene::Body& body, const mesh::Mesh& mesh) : number(3 * mesh.nodes.size()) {
    for (const auto& fixed : body.fixed) {
      for (const Index node : mesh::find_group(mesh, fixed.group, fixed.where)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          number[3 * static_cast<std::size_t>(node) + axis] = fixed.axes[axis] ? -1 : 0;
        }
      }
    }
    for (PetscInt& each : number) {
      each = each < 0 ? -1 : count++;
    }
  }
};

/// K of the undeformed body among the free components, N/m.
PetscErrorCode assemble_stiffness(const mesh::Mesh& mesh, const scene::Material& material, const Unknowns& unknowns,
                                  Mat* stiffness) {
  PetscFunctionBeginUser;
  const auto width = static_cast<std::size_t>(mesh::nodes_per_element(mesh.element));
  const std::vector<Vector3> at_rest(width, Vector3::Zero());
  std::vector<Vector3> reference(width);
  std::vector<PetscInt> components(3 * width);
  std::vector<PetscInt> rows;
  std::vector<PetscInt> columns;
  std::vector<double> values;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    for (std::size_t a = 0; a < width; ++a) {
      reference[a] = mesh.nodes[static_cast<std::size_t>(nodes[a])];
      std::copy_n(&unknowns.number[3 * static_cast<std::size_t>(nodes[a])], 3, &components[3 * a]);
    }
    const Eigen::MatrixXd k = solid::tangent_stiffness(mesh.element, solid::elasticity(material), reference, at_rest);
    values.insert(values.end(), k.data(), k.data() + k.size());
    for (const PetscInt column : components) {
      rows.insert(rows.end(), components.begin(), components.end());
      columns.insert(columns.end(), components.size(), column);
    }
  }
  PetscCall(MatCreate(PETSC_COMM_SELF, stiffness));
  PetscCall(MatSetSizes(*stiffness, unknowns.count, unknowns.count, unknowns.count, unknowns.count));
  PetscCall(MatSetType(*stiffness, MATSEQAIJ));
  PetscCall(MatSetPreallocationCOO(*stiffness, static_cast<PetscCount>(rows.size()), rows.data(), columns.data()));
  PetscCall(MatSetValuesCOO(*stiffness, values.data(), INSERT_VALUES));
  PetscCall(MatSetOption(*stiffness, MAT_SYMMETRIC, PETSC_TRUE));
  PetscCall(MatSetOption(*stiffness, MAT_SPD, PETSC_TRUE));
  PetscFunctionReturn(0);
}

/// The lumped mass that the run uses, of the free components, kg.
PetscErrorCode assemble_mass(const mesh::Mesh& mesh, const scene::Material& material, const Unknowns& unknowns,
                             Mat* mass) {
  PetscFunctionBeginUser;
  const mesh::Part part = mesh::distribute({mesh}, MPI_COMM_SELF);
  std::vector<double> nodal(mesh.nodes.size());
  solid::Solid(part.bodies.front(), part.reference, material).add_mass(nodal);
  PetscCall(MatCreateSeqAIJ(PETSC_COMM_SELF, unknowns.count, unknowns.count, 1, nullptr, mass));
  for (std::size_t c = 0; c < unknowns.number.size(); ++c) {
    if (const PetscInt number = unknowns.number[c]; number >= 0) {
      PetscCall(MatSetValue(*mass, number, number, nodal[c / 3], INSERT_VALUES));
    }
  }
  PetscCall(MatAssemblyBegin(*mass, MAT_FINAL_ASSEMBLY));
  PetscCall(MatAssemblyEnd(*mass, MAT_FINAL_ASSEMBLY));
  PetscFunctionReturn(0);
}

/// Prints the lowest frequencies of K x = (2 pi f)^2 M x: Krylov-Schur with MUMPS's factors of K.
PetscErrorCode print_frequencies(Mat stiffness, Mat mass, PetscInt count) {
  PetscFunctionBeginUser;
  EPS solver = nullptr;
  ST shift = nullptr;
  KSP linear = nullptr;
  PC factors = nullptr;
  PetscCall(EPSCreate(PETSC_COMM_SELF, &solver));
  PetscCall(EPSSetOperators(solver, stiffness, mass));
  PetscCall(EPSSetProblemType(solver, EPS_GHEP));
  PetscCall(EPSSetDimensions(solver, count, PETSC_DEFAULT, PETSC_DEFAULT));
  PetscCall(EPSSetTarget(solver, 0.0));
  PetscCall(EPSSetWhichEigenpairs(solver, EPS_TARGET_MAGNITUDE));
  PetscCall(EPSSetTolerances(solver, 1e-10, PETSC_DEFAULT));
  PetscCall(EPSGetST(solver, &shift));
  PetscCall(STSetType(shift, STSINVERT));
  PetscCall(STGetKSP(shift, &linear));
  PetscCall(KSPSetType(linear, KSPPREONLY));
  PetscCall(KSPGetPC(linear, &factors));
  PetscCall(PCSetType(factors, PCCHOLESKY));
  PetscCall(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
  PetscCall(EPSSetFromOptions(solver));
  PetscCall(EPSSolve(solver));
  PetscInt found = 0;
  PetscCall(EPSGetConverged(solver, &found));
  for (PetscInt i = 0; i < std::min(found, count); ++i) {
    PetscScalar eigenvalue = 0.0;
    PetscCall(EPSGetEigenvalue(solver, i, &eigenvalue, nullptr));
    fmt::print("{:.4f}\n", std::sqrt(eigenvalue) / (2 * std::numbers::pi));
  }
  PetscCall(EPSDestroy(&solver));
  PetscFunctionReturn(0);
}

PetscErrorCode find_modes(const scene::Scene& scene, PetscInt count) {
  PetscFunctionBeginUser;
  const scene::Body& body = scene.bodies.front();
  const scene::Material& material = scene.materials[body.material];
  const mesh::Mesh mesh = mesh::read_mesh(body);
  const Unknowns unknowns(body, mesh);
  Mat stiffness = nullptr;
  Mat mass = nullptr;
  PetscCall(assemble_stiffness(mesh, material, unknowns, &stiffness));
  PetscCall(assemble_mass(mesh, material, unknowns, &mass));
  fmt::print("# {} elements, {} free components\n", mesh.element_count(), unknowns.count);
  PetscCall(print_frequencies(stiffness, mass, count));
  PetscCall(MatDestroy(&stiffness));
  PetscCall(MatDestroy(&mass));
  PetscFunctionReturn(0);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 3) {
    fmt::print(stderr, "converged_modes DECK COUNT [KEY=VALUE ...]\n");
    return 2;
  }
  SlepcInitialize(nullptr, nullptr, nullptr, nullptr);
  int status = 0;
  try {
    const std::vector<std::string> overrides(arguments + 3, arguments + argument_count);
    status = find_modes(scene::read_deck(arguments[1], overrides), std::stoi(arguments[2])) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    status = 2;
  }
  SlepcFinalize();
  return status;
}
