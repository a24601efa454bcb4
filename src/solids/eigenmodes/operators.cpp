#include "operators.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/joints/joints.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"
#include "idiophone/solids/motion/prestress_balance.hpp"
#include "idiophone/solids/solid/consistent_mass.hpp"
#include "rest.hpp"
#include "with_ghosts.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

/// Numbers the free components rank by rank, and gets the numbers of the ghosts' from their owners.
motion::Components number_free(const mesh::Part& part, const std::vector<Index>& held, MPI_Comm communicator) {
  motion::Components components;
  components.number.assign(3 * part.node_ids.size(), 0);
  for (const Index component : held) {
    components.number[component] = -1;
  }
  const auto owned = static_cast<PetscInt>(3 * part.owned_nodes);
  const std::vector<int> free = parallel::gather(owned - static_cast<PetscInt>(held.size()), communicator);
  components.begin = parallel::offsets_of(free)[parallel::rank_of(communicator)];
  components.end = components.begin;
  for (PetscInt c = 0; c < owned; ++c) {
    PetscInt& number = components.number[c];
    number = number < 0 ? -1 : components.end++;
  }
  const parallel::Datatype node(3, MPIU_INT);
  const parallel::Handle<PetscSF> ghosts = motion::ghost_exchange(part, communicator);
  PetscInt* numbers = components.number.data();
  petsc(PetscSFBcastBegin(ghosts, node.get(), numbers, numbers + owned, MPI_REPLACE));
  petsc(PetscSFBcastEnd(ghosts, node.get(), numbers, numbers + owned, MPI_REPLACE));
  return components;
}

void finish(Mat matrix) {
  petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  petsc(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
}

}  // namespace

Operators::Operators(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
                     MPI_Comm communicator)
    : dynamics_(solids, part, attachments),
      components_(number_free(part, dynamics_.constraints().held_components(), communicator)),
      support_(part.owned_nodes),
      dashpot_(part.owned_nodes),
      rest_(part.node_ids.size()) {
  dynamics_.loads().add_support_stiffness(support_);
  dynamics_.loads().add_support_damping(dashpot_);
  size_ = parallel::sum(components_.end - components_.begin, communicator);
}

Operators::Operators(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
                     MassMatrix mass, MPI_Comm communicator)
    : Operators(solids, part, attachments, communicator) {
  const std::vector<char> deformed = motion::deformed_by_prestress(solids, part, dynamics_, communicator);
  is_deformed_ = std::ranges::count(deformed, 1) > 0;
  if (is_deformed_) {
    rest_ = rest_under_prestress(solids, part, dynamics_, deformed, support_, components_, communicator);
  }
  assemble(part, mass, communicator);
}

Operators::Operators(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
                     MassMatrix mass, std::span<const double> rest, MPI_Comm communicator)
    : Operators(solids, part, attachments, communicator) {
  is_deformed_ = true;
  const std::vector<double> displacements = with_ghosts(part, rest, communicator);
  for (std::size_t c = 0; c < displacements.size(); ++c) {
    rest_[c / 3].displacement[c % 3] = displacements[c];
  }
  assemble(part, mass, communicator);
}

void Operators::assemble(const mesh::Part& part, MassMatrix mass, MPI_Comm communicator) {
  const joints::Joints& joints = dynamics_.joints();
  stiffness_ = motion::create_matrix(part.bodies, components_, motion::Coupling::of_all_axes, communicator,
                                     joints::coupled_nodes(joints.all()));
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    motion::add_tangent_stiffness(part, part.bodies[b], dynamics_.solid(b), &solid::Solid::elasticity, rest_,
                                  components_, stiffness_);
  }
  add_diagonal(stiffness_, support_);
  motion::add_joint_stiffness(joints, rest_, components_, stiffness_);
  finish(stiffness_);
  if (mass == MassMatrix::consistent) {
    mass_ = motion::create_matrix(part.bodies, components_, motion::Coupling::of_each_axis, communicator);
    for (std::size_t b = 0; b < part.bodies.size(); ++b) {
      add_elements(part, b, mass_, [&](std::size_t region, std::span<const Vector3> positions) {
        return solid::consistent_mass(part.bodies[b].element, dynamics_.solid(b).density(region), positions);
      });
    }
  } else {
    add_lumped_mass(part.bodies.size(), communicator);
  }
  finish(mass_);
}

void Operators::add_elements(
    const mesh::Part& part, std::size_t number, Mat matrix,
    const std::function<Eigen::MatrixXd(std::size_t region, std::span<const Vector3> positions)>& of_element) {
  const mesh::BodyPart& body = part.bodies[number];
  std::vector<Vector3> positions;
  motion::add_elements(
      body, components_,
      [&](std::size_t element) {
        positions.clear();
        for (const Index node : body.element_nodes(element)) {
          positions.push_back(part.reference[node]);
        }
        return of_element(static_cast<std::size_t>(body.region(element)), positions);
      },
      matrix);
}

void Operators::add_lumped_mass(std::size_t bodies, MPI_Comm communicator) {
  PetscInt entries = 1;
  for (std::size_t b = 0; b < bodies; ++b) {
    entries = std::max<PetscInt>(entries, dynamics_.mass(b).entries_per_row());
  }
  const PetscInt mine = components_.end - components_.begin;
  petsc(MatCreateAIJ(communicator, mine, mine, PETSC_DETERMINE, PETSC_DETERMINE, entries, nullptr, entries - 1, nullptr,
                     mass_.out()));
  for (std::size_t b = 0; b < bodies; ++b) {
    dynamics_.mass(b).for_each_entry([&](Index row, Index column, double value) {
      petsc(MatSetValues(mass_, 1, &components_.number[row], 1, &components_.number[column], &value, ADD_VALUES));
    });
  }
}

void Operators::add_diagonal(Mat matrix, const std::vector<double>& values) const {
  for (std::size_t c = 0; c < 3 * values.size(); ++c) {
    const PetscInt number = components_.number[c];
    petsc(MatSetValues(matrix, 1, &number, 1, &number, &values[c / 3], ADD_VALUES));
  }
}

parallel::Handle<Vec> Operators::restricted(const std::vector<double>& field) const {
  parallel::Handle<Vec> vector;
  petsc(MatCreateVecs(stiffness_, vector.out(), nullptr));
  PetscScalar* values = nullptr;
  petsc(VecGetArrayWrite(vector, &values));
  for (std::size_t c = 0; c < field.size(); ++c) {
    if (is_free(c)) {
      values[components_.number[c] - components_.begin] = field[c];
    }
  }
  petsc(VecRestoreArrayWrite(vector, &values));
  return vector;
}

std::vector<double> Operators::extended(Vec vector) const {
  const PetscScalar* values = nullptr;
  petsc(VecGetArrayRead(vector, &values));
  std::vector<double> field(3 * support_.size());
  for (std::size_t c = 0; c < field.size(); ++c) {
    field[c] = is_free(c) ? values[components_.number[c] - components_.begin] : 0.0;
  }
  petsc(VecRestoreArrayRead(vector, &values));
  return field;
}

}  // namespace idiophone::eigenmodes
