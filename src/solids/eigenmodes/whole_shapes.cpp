#include "idiophone/solids/eigenmodes/whole_shapes.hpp"

#include <algorithm>
#include <span>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::eigenmodes {

std::vector<std::vector<double>> whole_shapes(const Modes& found, const mesh::Part& part, MPI_Comm communicator) {
  const std::span<const Index> own = std::span(part.node_ids).first(static_cast<std::size_t>(part.owned_nodes));
  const std::vector<Index> numbers = parallel::gather_all(own, communicator).values;
  std::vector<std::vector<double>> shapes;
  for (const Mode& mode : found.modes) {
    const std::vector<double> values = parallel::gather_all(std::span<const double>(mode.shape), communicator).values;
    if (parallel::is_root(communicator)) {
      auto& shape = shapes.emplace_back(values.size());
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        std::copy_n(&values[3 * n], 3, &shape[3 * static_cast<std::size_t>(numbers[n])]);
      }
    }
  }
  return shapes;
}

}  // namespace idiophone::eigenmodes
