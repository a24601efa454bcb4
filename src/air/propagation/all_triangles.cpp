#include "all_triangles.hpp"

#include <algorithm>
#include <span>

#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::propagation {

std::vector<std::array<Index, 3>> all_triangles(const propagation::AudibleSurface& surface, MPI_Comm communicator) {
  const std::vector<Index> numbers =
      parallel::gather_all(std::span<const Index>(surface.triangle_ids), communicator).values;
  const std::vector<Index> corners =
      parallel::gather_all(std::span<const Index>(propagation::global_corners(surface)), communicator).values;
  std::vector<std::array<Index, 3>> triangles(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::copy_n(&corners[3 * i], 3, triangles[numbers[i]].begin());
  }
  return triangles;
}

}  // namespace idiophone::propagation
