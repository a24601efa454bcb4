#include "face_groups.hpp"

#include <fmt/ranges.h>

#include "idiophone/scene/ranges.hpp"

namespace idiophone::scene {

/// A name for faces of a part.
struct FaceGroup {
  std::string name;
  std::string description;
};

/// {faces: [3, 4]}, {normal: [0, 0, 1]} or {box: [[0, 0, 0], [1, 1, 0.01]]}
static bool read(const Node& node, Mistakes& mistakes, FaceGroup& group) {
  std::vector<int> faces;
  Vector3 normal = Vector3::Zero();
  std::vector<Vector3> corners;
  Section section(node, mistakes);
  section.optional("faces", faces, Range{.at_least = 1, .at_most = 1e9});
  if (const Node* child = section.find("normal"); child != nullptr) {
    read(*child, mistakes, normal, unit_vector);
  }
  section.optional("box", corners, coordinate);
  if (!section.finish()) {
    return false;
  }
  if (node.children.size() != 1) {
    return mistakes.add(node, "needs one of the keys faces, normal and box");
  }
  if (!faces.empty()) {
    group.description = fmt::format("faces {}", fmt::join(faces, " "));
  } else if (!normal.isZero(0.0)) {
    group.description = fmt::format("normal {} {} {}", normal.x(), normal.y(), normal.z());
  } else if (corners.size() == 2) {
    group.description = fmt::format("box {} {} {} {} {} {}", corners[0].x(), corners[0].y(), corners[0].z(),
                                    corners[1].x(), corners[1].y(), corners[1].z());
  } else {
    return mistakes.add(node, "expected the numbers of faces, or two corners of a box");
  }
  return true;
}

FaceGroups read_face_groups(Section& body) {
  std::vector<FaceGroup> groups;
  body.optional("groups", groups);
  FaceGroups descriptions;
  for (const FaceGroup& group : groups) {
    descriptions.emplace(group.name, group.description);
  }
  return descriptions;
}

void describe_group(const FaceGroups& groups, std::string& name) {
  if (const auto found = groups.find(name); found != groups.end()) {
    name = found->second;
  }
}

}  // namespace idiophone::scene
