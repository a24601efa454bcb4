#include "part_statistics.hpp"

#include <algorithm>

#include "element_measures.hpp"
#include "element_shape.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::mesh {

Statistics gathered_statistics(const Mesh& outline, const Mesh& own, std::span<const char> owned,
                               std::span<const Index> numbers, std::size_t regions, MPI_Comm communicator) {
  std::vector<Box> box;
  if (parallel::is_root(communicator)) {
    box.push_back(box_of(outline));
  }
  parallel::broadcast(box, communicator);
  ElementMeasures measures = measures_of(own, box.front().axes, owned);
  if (measures.elements > 0) {
    measures.worst_element = numbers[measures.worst_element];
  }
  ElementMeasures all;
  std::ranges::for_each(parallel::gather(measures, communicator), [&](const auto& other) { all.add(other); });
  std::vector<double> volumes = region_volumes(own, regions, owned);
  parallel::reduce(volumes, MPI_SUM, communicator);
  if (!parallel::is_root(communicator)) {
    return {};
  }
  Statistics result = statistics(outline, box.front(), all);
  result.volumes = std::move(volumes);
  return result;
}

}  // namespace idiophone::mesh
