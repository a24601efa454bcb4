#include "idiophone/solids/motion/assembly.hpp"

#include <algorithm>
#include <set>

#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// Entries in each owned row: those in owned columns and those in others. [owned components]
struct RowLengths {
  std::vector<PetscInt> owned;
  std::vector<PetscInt> others;
};

RowLengths row_lengths(const mesh::BodyPart& body, const Components& components) {
  std::vector<std::set<Index>> neighbours(body.owned_end - body.owned_begin);
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    const std::span<const Index> nodes = body.element_nodes(element);
    for (const Index node : nodes) {
      if (node >= body.owned_begin && node < body.owned_end) {
        neighbours[node - body.owned_begin].insert(nodes.begin(), nodes.end());
      }
    }
  }
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
    const auto rows = std::ranges::count_if(numbers(body.owned_begin + n), [](PetscInt row) { return row >= 0; });
    lengths.owned.insert(lengths.owned.end(), rows, owned);
    lengths.others.insert(lengths.others.end(), rows, others);
  }
  return lengths;
}

}  // namespace

parallel::Handle<Mat> create_matrix(const mesh::BodyPart& body, const Components& components, MPI_Comm communicator) {
  const RowLengths lengths = row_lengths(body, components);
  const PetscInt rows = components.end - components.begin;
  parallel::Handle<Mat> matrix;
  petsc(MatCreateAIJ(communicator, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, 0, lengths.owned.data(), 0,
                     lengths.others.data(), matrix.out()));
  petsc(MatSetOption(matrix, MAT_IGNORE_OFF_PROC_ENTRIES, PETSC_TRUE));
  return matrix;
}

void add_elements(const mesh::BodyPart& body, const Components& components, const ElementMatrix& element_matrix,
                  Mat matrix) {
  std::vector<PetscInt> numbers;
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    numbers.clear();
    for (const Index node : body.element_nodes(element)) {
      const auto first = components.number.begin() + 3 * static_cast<std::ptrdiff_t>(node);
      numbers.insert(numbers.end(), first, first + 3);
    }
    const Eigen::MatrixXd values = element_matrix(element);
    const auto size = static_cast<PetscInt>(numbers.size());
    petsc(MatSetValues(matrix, size, numbers.data(), size, numbers.data(), values.data(), ADD_VALUES));
  }
}

}  // namespace idiophone::motion
