#include "fracture_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "group_faces.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

[[noreturn]] void refuse_surface(const scene::Body& body, const scene::FractureSurface& fracture,
                                 const std::string& why) {
  throw deck::DeckError(fracture.where,
                        fmt::format("bodies.{}.fracture: the surface '{}' {}", body.name, fracture.group, why));
}

/// The places in Body::fracture of the surfaces that a face lies on.
std::vector<std::size_t> surfaces_of(const ElementFace& face, const std::vector<GroupFaces>& fracture) {
  std::vector<std::size_t> found;
  for (std::size_t surface = 0; surface < fracture.size(); ++surface) {
    if (fracture[surface].has(face)) {
      found.push_back(surface);
    }
  }
  return found;
}

void refuse_empty_surfaces(const scene::Body& body, const FractureSurfaces& found) {
  for (std::size_t surface = 0; surface < body.fracture.size(); ++surface) {
    if (std::ranges::find(found.faces, surface, &TouchingFaces::surface) == found.faces.end()) {
      refuse_surface(body, body.fracture[surface],
                     "has no faces inside the body: name a Physical Surface of gmsh that is embedded in the volume, or "
                     "lies between two volumes");
    }
  }
}

void mark_nodes(const Mesh& mesh, FractureSurfaces& found) {
  found.on_them.resize(mesh.nodes.size());
  for (const TouchingFaces& face : found.faces) {
    const auto nodes = mesh.element_nodes(face.sides[0].element);
    for (const int place : element::reference(mesh.element).faces[face.sides[0].side].nodes) {
      found.on_them[nodes[place]] = 1;
    }
  }
}

}  // namespace

std::size_t triangle_count(std::span<const FractureFace> faces) {
  return std::transform_reduce(faces.begin(), faces.end(), std::size_t{0}, std::plus<>(),
                               [](const FractureFace& face) { return face.triangles; });
}

FractureSurfaces find_fracture_surfaces(const Mesh& mesh, const scene::Body& body) {
  std::vector<GroupFaces> fracture;
  for (const scene::FractureSurface& surface : body.fracture) {
    fracture.emplace_back(mesh, surface.group, surface.where);
  }
  FractureSurfaces found;
  for_each_shared_face(mesh, [&](std::span<const ElementFace> faces) {
    const std::vector<std::size_t> surfaces = surfaces_of(faces.front(), fracture);
    if (faces.size() == 1) {
      found.outside.push_back(faces.front());
      if (!surfaces.empty()) {
        refuse_surface(body, body.fracture[surfaces.front()],
                       "has faces on the outside of the body, where nothing joins");
      }
    } else if (surfaces.size() > 1) {
      refuse_surface(body, body.fracture[surfaces[1]],
                     fmt::format("shares faces with '{}'", body.fracture[surfaces[0]].group));
    } else if (surfaces.size() == 1) {
      found.faces.push_back({surfaces.front(), {faces[0], faces[1]}});
    }
  });
  refuse_empty_surfaces(body, found);
  mark_nodes(mesh, found);
  return found;
}

}  // namespace idiophone::mesh
