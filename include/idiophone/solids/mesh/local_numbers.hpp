#pragma once
// From global node numbers to those of a part.

#include <algorithm>
#include <span>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

class LocalNumbers {
 public:
  /// @param part  must outlive this object
  explicit LocalNumbers(const Part& part) : part_(part) {}

  /// Of a node that the part has, its own or a ghost.
  [[nodiscard]] Index of(Index node) const {
    const auto ghosts = part_.node_ids.begin() + part_.owned_nodes;
    const auto found = std::lower_bound(part_.node_ids.begin(), ghosts, node);
    const bool is_owned = found != ghosts && *found == node;
    return static_cast<Index>((is_owned ? found : std::lower_bound(ghosts, part_.node_ids.end(), node)) -
                              part_.node_ids.begin());
  }

  [[nodiscard]] bool owns(Index node) const {
    const auto owned = std::span(part_.node_ids).first(part_.owned_nodes);
    return std::ranges::binary_search(owned, node);
  }

 private:
  const Part& part_;
};

}  // namespace idiophone::mesh
