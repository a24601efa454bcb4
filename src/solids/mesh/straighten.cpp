#include "straighten.hpp"

#include <fmt/format.h>

#include <set>

#include "element_shape.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

constexpr std::size_t named_at_most = 3;  ///< places in a note

/// Do the elements have nodes in the middle of their edges, and no others beside the corners?
bool has_middle_nodes(const element::ReferenceElement& reference) {
  return reference.nodes.size() == reference.corners.size() + reference.edges.size();
}

/// The same corners, with the other nodes in the middle of straight edges.
ElementShape straight(ElementShape shape) {
  const element::ReferenceElement& reference = element::reference(shape.type);
  auto node = shape.nodes.begin() + std::ssize(reference.corners);
  for (const auto& [i, j] : reference.edges) {
    *node++ = 0.5 * (shape.nodes[i] + shape.nodes[j]);
  }
  return shape;
}

bool is_folded(const ElementShape& shape) {
  return !(quality_of(shape) >= flat_quality) && quality_of(straight(shape)) >= flat_quality;
}

}  // namespace

std::string straighten_distorted(Mesh& mesh) {
  if (!has_middle_nodes(element::reference(mesh.element))) {
    return "";
  }
  std::set<Index> straightened;
  for (bool again = true; again;) {  // straight edges may distort a neighbour whose other edges are curved
    again = false;
    for (Index element = 0; element < mesh.element_count(); ++element) {
      const ElementShape shape = shape_of(mesh, element);
      if (straightened.contains(element) || !is_folded(shape)) {
        continue;
      }
      const ElementShape better = straight(shape);
      const auto nodes = mesh.element_nodes(element);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        mesh.nodes[nodes[i]] = better.nodes[i];
      }
      straightened.insert(element);
      again = true;
    }
  }
  if (straightened.empty()) {
    return "";
  }
  std::string places;
  for (const Index element : straightened) {
    if (const std::size_t named = static_cast<std::size_t>(std::ranges::count(places, '(')); named < named_at_most) {
      const Vector3 centre = centre_of(shape_of(mesh, element));
      places += fmt::format("{} ({:.4g}, {:.4g}, {:.4g})", named == 0 ? "" : ",", centre.x(), centre.y(), centre.z());
    }
  }
  return fmt::format(
      "{} of {} elements have straight edges, because edges along the curved surface would fold them; at{}{}; "
      "a finer mesh keeps more of the curve",
      straightened.size(), mesh.element_count(), places, straightened.size() > named_at_most ? ", ..." : "");
}

}  // namespace idiophone::mesh
