#include "group_faces.hpp"

#include <algorithm>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

GroupFaces::GroupFaces(const Mesh& mesh, const std::string& group, const deck::Location& where)
    : mesh_(mesh), nodes_(mesh.nodes.size()) {
  for (const Index node : find_group(mesh, group, where)) {
    nodes_[node] = 1;
  }
  if (const auto found = mesh.group_triangles.find(group); found != mesh.group_triangles.end()) {
    for (Triangle triangle : found->second) {
      std::ranges::sort(triangle);
      triangles_.insert(triangle);
    }
  }
}

bool GroupFaces::has(const ElementFace& face) const {
  const auto nodes = mesh_.element_nodes(face.element);
  const auto& places = element::reference(mesh_.element).faces[face.side].nodes;
  if (!std::ranges::all_of(places, [&](int place) { return nodes_[nodes[place]] != 0; })) {
    return false;
  }
  switch (mesh_.element.kind) {
    case element::Kind::tet4:
      return triangles_.contains({face.corners[1], face.corners[2], face.corners[3]});
    case element::Kind::tet10:
    case element::Kind::hex:
      return true;
  }
  element::unknown_kind();
}

std::vector<ElementFace> outer_faces(const Mesh& mesh, const std::string& group, const deck::Location& where) {
  const GroupFaces of_group(mesh, group, where);
  std::vector<ElementFace> outer;
  for_each_shared_face(mesh, [&](std::span<const ElementFace> faces) {
    if (faces.size() == 1 && of_group.has(faces.front())) {
      outer.push_back(faces.front());
    }
  });
  return outer;
}

}  // namespace idiophone::mesh
