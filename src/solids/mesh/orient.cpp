#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "checks.hpp"
#include "surface_mesh.hpp"

namespace idiophone::mesh {

namespace {

/// One quadrilateral along an edge.
struct DirectedSide {
  Index quadrilateral;
  bool ascending;  ///< it leads from the edge's lower node to the higher one
};

using SidesOfEdges =
    std::map<std::pair<Index, Index>, std::vector<DirectedSide>>;  ///< by the nodes at its ends, ascending

/// Around the quadrilateral.
std::array<Index, 4> corners_of(const SurfaceMesh& surface, Index number) {
  const auto nodes = surface.quadrilateral(number);
  const int last = (surface.order + 1) * (surface.order + 1) - 1;
  return {nodes[0], nodes[surface.order], nodes[last], nodes[last - surface.order]};
}

SidesOfEdges sides_of_edges(const SurfaceMesh& surface) {
  SidesOfEdges edges;
  for (Index number = 0; number < std::ssize(surface.element_tags); ++number) {
    const auto corners = corners_of(surface, number);
    for (std::size_t a = 0; a < 4; ++a) {
      const Index from = corners[a];
      const Index to = corners[(a + 1) % 4];
      edges[std::minmax({from, to})].push_back({number, from < to});
    }
  }
  return edges;
}

/// A quadrilateral across an edge.
struct Neighbour {
  Index quadrilateral;
  bool faces_otherwise;  ///< both lead along the edge in the same direction
};

std::vector<std::vector<Neighbour>> neighbours_of(const scene::Body& body, const SurfaceMesh& surface) {
  std::vector<std::vector<Neighbour>> neighbours(surface.element_tags.size());
  std::vector<std::string> crowded;
  for (const auto& [ends, sides] : sides_of_edges(surface)) {
    if (sides.size() > 2) {
      std::ranges::transform(sides, std::back_inserter(crowded),
                             [&](const DirectedSide& side) { return quadrilateral_text(surface, side.quadrilateral); });
    } else if (sides.size() == 2) {
      const bool otherwise = sides[0].ascending == sides[1].ascending;
      neighbours[sides[0].quadrilateral].push_back({sides[1].quadrilateral, otherwise});
      neighbours[sides[1].quadrilateral].push_back({sides[0].quadrilateral, otherwise});
    }
  }
  if (!crowded.empty()) {
    refuse_culprits(body, "has edges that more than two quadrilaterals share; a wall can't branch:", crowded);
  }
  return neighbours;
}

/// Exchanges the two directions.
void turn_over(SurfaceMesh& surface, Index number) {
  const std::ptrdiff_t width = surface.order + 1;
  const auto first = surface.elements.begin() + number * width * width;
  for (std::ptrdiff_t j = 0; j < width; ++j) {
    for (std::ptrdiff_t i = 0; i < j; ++i) {
      std::swap(first[i + width * j], first[j + width * i]);
    }
  }
}

enum class Facing : std::uint8_t { unknown, as_it_is, turned };

}  // namespace

void orient(const scene::Body& body, SurfaceMesh& surface) {
  const auto neighbours = neighbours_of(body, surface);
  std::vector<Facing> facing(neighbours.size(), Facing::unknown);
  for (Index seed = 0; seed < std::ssize(facing); ++seed) {
    if (facing[seed] != Facing::unknown) {
      continue;
    }
    facing[seed] = Facing::as_it_is;
    std::vector<Index> reached = {seed};
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const Index here = reached[next];
      for (const auto& [there, faces_otherwise] : neighbours[here]) {
        const Facing wanted = (facing[here] == Facing::turned) == faces_otherwise ? Facing::as_it_is : Facing::turned;
        if (facing[there] == Facing::unknown) {
          facing[there] = wanted;
          reached.push_back(there);
        } else if (facing[there] != wanted) {
          refuse_culprits(body,
                          "has one side only, like a Möbius strip: no choice makes all neighbours face the same side. "
                          "Two that cannot agree:",
                          {quadrilateral_text(surface, here), quadrilateral_text(surface, there)});
        }
      }
    }
  }
  for (Index number = 0; number < std::ssize(facing); ++number) {
    if (facing[number] == Facing::turned) {
      turn_over(surface, number);
    }
  }
}

std::string quadrilateral_text(const SurfaceMesh& surface, Index number) {
  Vector3 centre = Vector3::Zero();
  for (const Index corner : corners_of(surface, number)) {
    centre += surface.nodes[corner] / 4;
  }
  return element_text(surface.element_tags[number], centre);
}

}  // namespace idiophone::mesh
