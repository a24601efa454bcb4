#include "idiophone/solids/motion/assembly.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/sequential_rows.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// The local nodes that each owned node shares an element or a coupling with, itself included, ascending.
/// [owned nodes] none where no component of the node has a row
std::vector<std::vector<Index>> neighbours_of(std::span<const mesh::BodyPart> bodies, const Components& components,
                                              std::span<const std::vector<Index>> coupled) {
  const Index begin = bodies.front().owned_begin;
  const Index end = bodies.back().owned_end;
  std::vector<std::vector<Index>> neighbours(end - begin);
  const auto has_rows = [&](Index node) {
    const auto numbers = std::span(components.number).subspan(3 * static_cast<std::size_t>(node), 3);
    return std::ranges::max(numbers) >= 0;
  };
  const auto couple = [&](std::span<const Index> nodes) {
    for (const Index node : nodes) {
      if (node >= begin && node < end && has_rows(node)) {
        neighbours[node - begin].insert(neighbours[node - begin].end(), nodes.begin(), nodes.end());
      }
    }
  };
  for (const mesh::BodyPart& body : bodies) {
    for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
      couple(body.element_nodes(element));
    }
  }
  std::ranges::for_each(coupled, couple);
  for (std::vector<Index>& nodes : neighbours) {
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  return neighbours;
}

/// Where the entries of the owned rows are.
struct Entries {
  std::vector<PetscInt> begins = {0};  ///< [rows + 1]
  std::vector<PetscInt> columns;       ///< of each row, ascending
};

Entries entries_of(std::span<const mesh::BodyPart> bodies, const Components& components, Coupling coupling,
                   std::span<const std::vector<Index>> coupled) {
  Entries entries;
  std::vector<PetscInt> columns;
  auto node = static_cast<std::size_t>(bodies.front().owned_begin);
  for (const std::vector<Index>& neighbours : neighbours_of(bodies, components, coupled)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (components.number[3 * node + axis] < 0) {
        continue;
      }
      columns.clear();
      for (const Index neighbour : neighbours) {
        for (std::size_t other = 0; other < 3; ++other) {
          const PetscInt column = components.number[3 * static_cast<std::size_t>(neighbour) + other];
          if (column >= 0 && (other == axis || coupling == Coupling::of_all_axes)) {
            columns.push_back(column);
          }
        }
      }
      std::ranges::sort(columns);
      entries.columns.insert(entries.columns.end(), columns.begin(), columns.end());
      entries.begins.push_back(static_cast<PetscInt>(entries.columns.size()));
    }
    ++node;
  }
  return entries;
}

void set_values(std::span<const PetscInt> numbers, const Eigen::MatrixXd& values, Mat matrix) {
  const auto size = static_cast<PetscInt>(numbers.size());
  petsc(MatSetValues(matrix, size, numbers.data(), size, numbers.data(), values.data(), ADD_VALUES));
}

/// Adds dense matrices to a sparse one on one rank, which has places for all that is not zero. PETSc would search for
/// each place.
class Adder {
 public:
  explicit Adder(Mat matrix) : rows_(matrix), place_(rows_.count()) {}

  /// @param numbers  of rows and columns; -1 where they are left out
  /// @param values   symmetric
  void add(std::span<const PetscInt> numbers, const Eigen::MatrixXd& values) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] >= 0) {
        find_places(rows_.columns(numbers[i]));
        add_row(rows_.values(numbers[i]), numbers, values.col(static_cast<Eigen::Index>(i)).data());
      }
    }
  }

 private:
  void find_places(std::span<const PetscInt> columns) {
    if (!std::ranges::equal(columns, columns_)) {  // those of a node are often alike
      columns_ = columns;
      for (std::size_t entry = 0; entry < columns.size(); ++entry) {
        place_[columns[entry]] = entry;
      }
    }
  }

  void add_row(std::span<double> row, std::span<const PetscInt> numbers, const double* values) const {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] >= 0 && values[i] != 0) {
        row[place_[numbers[i]]] += values[i];
      }
    }
  }

  parallel::SequentialRows rows_;
  std::span<const PetscInt> columns_;  ///< of the present row
  std::vector<std::size_t> place_;     ///< [columns] in the present row
};

/// Rows and columns of nodes. [3 x nodes]
std::vector<PetscInt> numbers_of(std::span<const Index> nodes, const Components& components) {
  std::vector<PetscInt> numbers;
  for (const Index node : nodes) {
    const auto first = components.number.begin() + 3 * static_cast<std::ptrdiff_t>(node);
    numbers.insert(numbers.end(), first, first + 3);
  }
  return numbers;
}

}  // namespace

parallel::Handle<Mat> create_matrix(std::span<const mesh::BodyPart> bodies, const Components& components,
                                    Coupling coupling, MPI_Comm communicator,
                                    std::span<const std::vector<Index>> coupled) {
  const auto [begins, columns] = entries_of(bodies, components, coupling, coupled);
  const PetscInt rows = components.end - components.begin;
  parallel::Handle<Mat> matrix;
  petsc(MatCreate(communicator, matrix.out()));
  petsc(MatSetSizes(matrix, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
  petsc(MatSetType(matrix, MATAIJ));
  petsc(MatSeqAIJSetPreallocationCSR(matrix, begins.data(), columns.data(), nullptr));
  petsc(MatMPIAIJSetPreallocationCSR(matrix, begins.data(), columns.data(), nullptr));
  petsc(MatSetOption(matrix, MAT_IGNORE_OFF_PROC_ENTRIES, PETSC_TRUE));
  petsc(MatSetOption(matrix, MAT_IGNORE_ZERO_ENTRIES, PETSC_TRUE));
  return matrix;
}

void add_elements(const mesh::BodyPart& body, const Components& components, const ElementMatrix& element_matrix,
                  Mat matrix) {
  std::optional<Adder> adder;
  if (parallel::SequentialRows::are_of(matrix)) {
    adder.emplace(matrix);
  }
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    const std::vector<PetscInt> numbers = numbers_of(body.element_nodes(element), components);
    adder ? adder->add(numbers, element_matrix(element)) : set_values(numbers, element_matrix(element), matrix);
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
    return solid::tangent_stiffness(body.element, (solid.*moduli)(region), solid.relaxed_elasticity(region), reference,
                                    displacement, solid.initial_stress(region));
  };
  add_elements(body, components, tangent, matrix);
}

void add_joint_stiffness(const joints::Joints& joints, std::span<const solid::NodeState> state,
                         const Components& components, Mat matrix) {
  for (std::size_t joint = 0; joint < joints.all().size(); ++joint) {
    joints.for_each_stiffness(joint, state, [&](std::span<const Index> nodes, const Eigen::MatrixXd& values) {
      set_values(numbers_of(nodes, components), values, matrix);
    });
  }
}

}  // namespace idiophone::motion
