#include "idiophone/solids/motion/assembly.hpp"

#include <algorithm>
#include <set>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// Entries in each owned row: those in owned columns and those in others. [owned components]
struct RowLengths {
  std::vector<PetscInt> owned;
  std::vector<PetscInt> others;
};

RowLengths row_lengths(std::span<const mesh::BodyPart> bodies, const Components& components,
                       std::span<const std::vector<Index>> coupled) {
  const Index begin = bodies.front().owned_begin;
  const Index end = bodies.back().owned_end;
  std::vector<std::set<Index>> neighbours(end - begin);
  const auto couple = [&](std::span<const Index> nodes) {
    for (const Index node : nodes) {
      if (node >= begin && node < end) {
        neighbours[node - begin].insert(nodes.begin(), nodes.end());
      }
    }
  };
  for (const mesh::BodyPart& body : bodies) {
    for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
      couple(body.element_nodes(element));
    }
  }
  std::ranges::for_each(coupled, couple);
  const auto numbers = [&](std::size_t node) { return std::span(components.number).subspan(3 * node, 3); };
  RowLengths lengths;
  for (std::size_t n = 0; n < neighbours.size(); ++n) {
    PetscInt owned = 0;
    PetscInt others = 0;
    for (const Index neighbour : neighbours[n]) {
      for (const PetscInt column : numbers(neighbour)) {
        const bool here = column >= components.begin && column < components.end;
        owned += here ? 1 : 0;
        others += column >= 0 && !here ? 1 : 0;
      }
    }
    const auto rows = std::ranges::count_if(numbers(begin + n), [](PetscInt row) { return row >= 0; });
    lengths.owned.insert(lengths.owned.end(), rows, owned);
    lengths.others.insert(lengths.others.end(), rows, others);
  }
  return lengths;
}

/// Adds a matrix between local nodes, [3 nodes x 3 nodes] as an element's.
void add_between(std::span<const Index> nodes, const Components& components, const Eigen::MatrixXd& values,
                 Mat matrix) {
  std::vector<PetscInt> numbers;
  for (const Index node : nodes) {
    const auto first = components.number.begin() + 3 * static_cast<std::ptrdiff_t>(node);
    numbers.insert(numbers.end(), first, first + 3);
  }
  const auto size = static_cast<PetscInt>(numbers.size());
  petsc(MatSetValues(matrix, size, numbers.data(), size, numbers.data(), values.data(), ADD_VALUES));
}

}  // namespace

parallel::Handle<Mat> create_matrix(std::span<const mesh::BodyPart> bodies, const Components& components,
                                    MPI_Comm communicator, std::span<const std::vector<Index>> coupled) {
  const RowLengths lengths = row_lengths(bodies, components, coupled);
  const PetscInt rows = components.end - components.begin;
  parallel::Handle<Mat> matrix;
  petsc(MatCreateAIJ(communicator, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, 0, lengths.owned.data(), 0,
                     lengths.others.data(), matrix.out()));
  petsc(MatSetOption(matrix, MAT_IGNORE_OFF_PROC_ENTRIES, PETSC_TRUE));
  return matrix;
}

void add_elements(const mesh::BodyPart& body, const Components& components, const ElementMatrix& element_matrix,
                  Mat matrix) {
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    add_between(body.element_nodes(element), components, element_matrix(element), matrix);
  }
}

void add_tangent_stiffness(const mesh::Part& part, const mesh::BodyPart& body, const solid::Solid& solid, Moduli moduli,
                           std::span<const solid::NodeState> state, const Components& components, Mat matrix) {
  std::vector<Vector3> reference;
  std::vector<Vector3> displacement;
  const auto tangent = [&](std::size_t element) {
    reference.clear();
    displacement.clear();
    for (const Index node : body.element_nodes(element)) {
      reference.push_back(part.reference[node]);
      displacement.emplace_back(state[node].displacement);
    }
    const auto region = static_cast<std::size_t>(body.region(element));
    return solid::tangent_stiffness(body.element, (solid.*moduli)(region), reference, displacement,
                                    solid.initial_stress(region));
  };
  add_elements(body, components, tangent, matrix);
}

void add_joint_stiffness(const joints::Joints& joints, std::span<const solid::NodeState> state,
                         const Components& components, Mat matrix) {
  for (std::size_t joint = 0; joint < joints.all().size(); ++joint) {
    joints.for_each_stiffness(joint, state, [&](std::span<const Index> nodes, const Eigen::MatrixXd& values) {
      add_between(nodes, components, values, matrix);
    });
  }
}

}  // namespace idiophone::motion
