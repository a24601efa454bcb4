#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "connected_parts.hpp"
#include "fracture_surfaces.hpp"
#include "hash.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "idiophone/solids/mesh/face_shares.hpp"
#include "ordered.hpp"

namespace idiophone::mesh {

namespace {

/// Where nodes of a face of an element are in Mesh::elements, corners first.
std::vector<Index> places_of(const Mesh& mesh, const ElementFace& face) {
  std::vector<Index> places;
  for (const int place : element::reference(mesh.element).faces[face.side].nodes) {
    places.push_back(face.element * element::node_count(mesh.element) + place);
  }
  return places;
}

/// Where the nodes of the second face are in Mesh::elements, in the order of the first face.
std::vector<Index> places_across(const Mesh& mesh, const std::array<ElementFace, 2>& sides) {
  const std::vector<Index> there = places_of(mesh, sides[1]);
  std::vector<Index> places;
  for (const Index here : places_of(mesh, sides[0])) {
    places.push_back(*std::ranges::find(there, mesh.elements[here], [&](Index place) { return mesh.elements[place]; }));
  }
  return places;
}

/// Places in Mesh::elements, those of one node together that elements join by faces off the fracture surfaces.
DisjointSets joined_places(const Mesh& mesh, const FractureSurfaces& surfaces) {
  DisjointSets joined(mesh.elements.size());
  auto next = surfaces.faces.begin();  // for_each_shared_face comes to them in this order
  for_each_shared_face(mesh, [&](std::span<const ElementFace> faces) {
    if (faces.size() == 1) {
      return;
    }
    if (next != surfaces.faces.end() && next->sides[0].corners == faces[0].corners) {
      ++next;
      return;
    }
    const std::array<ElementFace, 2> sides = {faces[0], faces[1]};
    const std::vector<Index> here = places_of(mesh, sides[0]);
    const std::vector<Index> there = places_across(mesh, sides);
    for (std::size_t k = 0; k < here.size(); ++k) {
      joined.join(here[k], there[k]);
    }
  });
  return joined;
}

/// The mesh with one node for each part of the body around a node on a surface. The first keeps its number.
/// @param parts  [nodes] set to the number of parts around each
Mesh separated(const Mesh& mesh, const FractureSurfaces& surfaces, std::vector<int>& parts) {
  Mesh result = mesh;
  result.group_triangles.clear();
  DisjointSets joined = joined_places(mesh, surfaces);
  std::unordered_map<Index, Index> node_of_part;
  std::vector<Index> copied;  // of each new node, the one that it is a copy of
  parts.assign(mesh.nodes.size(), 0);
  for (std::size_t place = 0; place < mesh.elements.size(); ++place) {
    const Index node = mesh.elements[place];
    if (surfaces.on_them[node] == 0) {
      continue;
    }
    const auto [known, fresh] = node_of_part.try_emplace(joined.root(static_cast<Index>(place)), node);
    if (fresh && parts[node]++ > 0) {
      known->second = static_cast<Index>(result.nodes.size());
      result.nodes.push_back(mesh.nodes[node]);
      copied.push_back(node);
    }
    result.elements[place] = known->second;
  }
  for (auto& [name, nodes] : result.groups) {
    for (std::size_t copy = 0; copy < copied.size(); ++copy) {
      if (std::ranges::binary_search(mesh.groups.at(name), copied[copy])) {
        nodes.push_back(static_cast<Index>(mesh.nodes.size() + copy));
      }
    }
  }
  return result;
}

[[noreturn]] void refuse_division(const scene::Body& body, std::size_t surface, const std::string& why) {
  throw deck::DeckError(body.fracture[surface].where, fmt::format("bodies.{}.fracture: the surface '{}' {}", body.name,
                                                                  body.fracture[surface].group, why));
}

void refuse_surfaces_that_divide_nothing(const scene::Body& body, const Mesh& divided) {
  for (std::size_t surface = 0; surface < body.fracture.size(); ++surface) {
    const auto opens = [&](const FractureFace& face) {
      return face.surface == surface && face.nodes[0] != face.nodes[1];
    };
    if (std::ranges::none_of(divided.fracture_faces, opens)) {
      refuse_division(body, surface, "divides nothing: all its nodes are on its rim inside the body. Make it finer");
    }
  }
}

/// The stress on a face is known from those of its nodes that it acts on and around which there are two parts.
void refuse_crowded_faces(const scene::Body& body, const Mesh& mesh, const FractureSurfaces& surfaces,
                          const std::vector<int>& parts) {
  for (const TouchingFaces& face : surfaces.faces) {
    std::vector<Index> loaded;  // nodes
    const std::vector<double> shares = face_shares(mesh, face.sides[0]);
    const std::vector<Index> places = places_of(mesh, face.sides[0]);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (shares[k] > 0) {
        loaded.push_back(mesh.elements[places[k]]);
      }
    }
    const auto parts_at = [&](Index node) { return parts[node]; };
    if (std::ranges::find(loaded, 2, parts_at) == loaded.end() &&
        parts_at(std::ranges::max(loaded, {}, parts_at)) > 2) {
      refuse_division(body, face.surface,
                      fmt::format("is too coarse at {}: a face has all its edges where fracture surfaces cross. Make "
                                  "it finer there",
                                  to_text(mesh.nodes[loaded.front()])));
    }
  }
}

/// @param divided  with the nodes of its elements
void add_fracture_faces(const Mesh& mesh, const FractureSurfaces& surfaces, Mesh& divided) {
  for (const TouchingFaces& touching : surfaces.faces) {
    FractureFace& face = divided.fracture_faces.emplace_back();
    const element::Face& of_element = element::reference(mesh.element).faces[touching.sides[0].side];
    face.surface = touching.surface;
    face.corners = of_element.corners.size();
    face.triangles = 2 * of_element.triangles.size();
    face.shares = face_shares(mesh, touching.sides[0]);
    const std::array<std::vector<Index>, 2> places = {places_of(mesh, touching.sides[0]),
                                                      places_across(mesh, touching.sides)};
    for (std::size_t side = 0; side < 2; ++side) {
      std::ranges::transform(places.at(side), std::back_inserter(face.nodes.at(side)),
                             [&](Index place) { return divided.elements[place]; });
      append_triangles(divided, touching.sides.at(side), divided.surface);
    }
  }
}

}  // namespace

Mesh divide(const Mesh& mesh, const scene::Body& body) {
  const FractureSurfaces surfaces = find_fracture_surfaces(mesh, body);
  std::vector<int> parts;
  Mesh divided = separated(mesh, surfaces, parts);
  divided.surface.clear();
  for (const ElementFace& face : surfaces.outside) {
    append_triangles(divided, face, divided.surface);
  }
  add_fracture_faces(mesh, surfaces, divided);
  refuse_surfaces_that_divide_nothing(body, divided);
  refuse_crowded_faces(body, mesh, surfaces, parts);
  Mesh result = ordered(divided).mesh;
  const auto outer = std::span(result.surface).first(result.outer_surface().size());
  std::ranges::for_each(outer, turn_smallest_first);
  std::ranges::sort(outer);
  if (const std::vector<Index> pieces = connected_parts(result); std::ranges::max(pieces) > 0) {
    result.pieces = pieces;
  }
  result.hash = hash_of(result);
  result.notes = mesh.notes;
  return result;
}

}  // namespace idiophone::mesh
