#include "idiophone/solids/joints/held_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "held_part.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::joints {

namespace {

constexpr std::size_t most_refined_nodes = 2000;  // of both parts: 0.4 GB of stiffness

/// A side of an element.
mesh::ElementFace face_at(const mesh::Mesh& mesh, Index element, std::size_t side) {
  mesh::ElementFace face{.element = element, .side = static_cast<Index>(side)};
  face.corners.fill(-1);
  std::ranges::transform(element::reference(mesh.element).faces[side].corners, face.corners.begin(),
                         [&](int place) { return mesh.element_nodes(element)[place]; });
  std::ranges::sort(face.corners);
  return face;
}

/// All nodes of a face, ascending.
std::vector<Index> nodes_of(const mesh::Mesh& mesh, const mesh::ElementFace& face) {
  std::vector<Index> nodes;
  std::ranges::transform(element::reference(mesh.element).faces[face.side].nodes, std::back_inserter(nodes),
                         [&](int place) { return mesh.element_nodes(face.element)[place]; });
  std::ranges::sort(nodes);
  return nodes;
}

/// @param held  on the mesh
HeldPart refined(const HeldPart& held, const mesh::Mesh& mesh, const mesh::RefinedMesh& refined) {
  const Index children = refined.mesh.element_count() / mesh.element_count();
  const std::size_t sides = element::reference(refined.mesh.element).faces.size();
  HeldPart result;
  for (const Index element : held.elements) {
    for (Index child = 0; child < children; ++child) {
      result.elements.push_back(children * element + child);
    }
  }
  for (const mesh::ElementFace& face : held.faces) {
    const std::vector<Index> nodes = nodes_of(mesh, face);
    const auto is_of_face = [&](const mesh::Parent& parent) { return std::ranges::binary_search(nodes, parent.node); };
    const auto lies_in_face = [&](Index corner) {
      return corner < 0 || std::ranges::all_of(refined.parents[corner], is_of_face);
    };
    for (Index child = 0; child < children; ++child) {
      for (std::size_t side = 0; side < sides; ++side) {
        const mesh::ElementFace candidate = face_at(refined.mesh, children * face.element + child, side);
        if (std::ranges::all_of(candidate.corners, lies_in_face)) {
          result.faces.push_back(candidate);
        }
      }
    }
  }
  return result;
}

}  // namespace

std::vector<Index> HeldPart::nodes(const mesh::Mesh& mesh) const {
  std::vector<Index> nodes;
  for (const Index element : elements) {
    const auto of_element = mesh.element_nodes(element);
    nodes.insert(nodes.end(), of_element.begin(), of_element.end());
  }
  keep_each_once(nodes);
  return nodes;
}

HeldParts held_parts(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  HeldParts held(solids.joints.size());
  for (std::size_t j = 0; j < held.size(); ++j) {
    const scene::Joint& joint = solids.joints[j];
    if (!joint.is_layer()) {
      held[j] = held_by(joint, meshes);
    }
  }
  return held;
}

HeldParts refined(const HeldParts& held, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                  const std::vector<mesh::RefinedMesh>& refined_meshes) {
  HeldParts result(held.size());
  for (std::size_t j = 0; j < held.size(); ++j) {
    const scene::Joint& joint = solids.joints[j];
    std::size_t nodes = 0;
    for (const std::size_t side : {0, 1}) {
      const std::size_t body = joint.surfaces[side].body;
      result[j][side] = refined(held[j][side], meshes[body], refined_meshes[body]);
      nodes += result[j][side].nodes(refined_meshes[body].mesh).size();
    }
    if (nodes > most_refined_nodes) {
      throw deck::DeckError(
          joint.where, fmt::format("joints.{} holds {} nodes of the refined elements, and at most {} are possible: {}",
                                   joint.name, nodes, most_refined_nodes, how_to_hold_less(joint)));
    }
  }
  return result;
}

}  // namespace idiophone::joints
