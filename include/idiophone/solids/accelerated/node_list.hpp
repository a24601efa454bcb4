#pragma once
// Some nodes of a body, whose motion goes to an accelerator and back.

#include <vector>

#include "idiophone/foundation/accelerator/array.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::accelerated {

struct NodeList {
  /// @param its_nodes  local numbers
  /// @param numbers    of the same nodes on the accelerator
  NodeList(accelerator::Accelerator& accelerator, std::vector<Index> its_nodes, const std::vector<Index>& numbers)
      : nodes(std::move(its_nodes)),
        values(6 * nodes.size()),
        numbers_there(accelerator, numbers),
        values_there(accelerator, values.size()) {}

  std::vector<Index> nodes;
  std::vector<double> values;  ///< what travels: 6 numbers of each node, or 3
  accelerator::Array<Index> numbers_there;
  accelerator::Array<double> values_there;
};

}  // namespace idiophone::accelerated
