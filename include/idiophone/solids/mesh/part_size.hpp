#pragma once
// How much of all bodies one rank has, and how much it exchanges: of a run's parts, or of those that it would have on
// another number of ranks.

#include <functional>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

/// Of one rank.
struct PartSize {
  Index elements = 0;        ///< that it owns
  Index ghost_elements = 0;  ///< that it computes, too, and others own
  Index nodes = 0;           ///< that it owns
  Index ghost_nodes = 0;     ///< whose motion it receives in each step
  Index triangles = 0;       ///< of the surface, that it owns
  Index neighbours = 0;      ///< ranks that it receives from, and sends to
  double work = 0.0;         ///< of all elements computed here, in the unit of work_of_element
};

[[nodiscard]] PartSize size_of(const Part& part);

/// The larger of each.
[[nodiscard]] PartSize largest(const PartSize& a, const PartSize& b);

/// Work of one element in a step, relative to a tet4 element's 4: METIS divides it evenly.
[[nodiscard]] double work_of_element(element::Type type);

/// Calls visit(part) with the part of each rank, rank 0's first, as `distribute` would make them.
/// @param ranks    that share the bodies; no process is needed for them
/// @param coupled  as `distribute` takes them
/// @throws std::runtime_error as `distribute`
void for_each_part(const std::vector<Mesh>& meshes, int ranks, const std::function<void(const Part&)>& visit,
                   std::span<const std::vector<Index>> coupled = {});

}  // namespace idiophone::mesh
