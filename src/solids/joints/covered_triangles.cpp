#include "idiophone/solids/joints/covered_triangles.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <span>

#include "facing_surface.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::joints {

namespace {

/// @param close  faces of the other surface that the triangle may face
bool is_covered(const mesh::Triangle& triangle, const std::vector<Vector3>& nodes, const FacingSurface& other,
                const std::vector<const SurfaceFace*>& close) {
  const Vector3 &a = nodes[triangle[0]], &b = nodes[triangle[1]], &c = nodes[triangle[2]];
  const Vector3 middle = (a + b + c) / 3.0;
  const Vector3 normal = (b - a).cross(c - a).normalized();
  return other.partner_of(middle, normal, close).has_value();
}

/// Marks the triangles of a joined surface that the other one covers.
/// @param faces    of the surface, as faces_of() gives them
/// @param covered  [triangles of the mesh]
void cover(const scene::JoinedSurface& surface, const Faces& faces, const mesh::Mesh& mesh, const FacingSurface& other,
           std::span<char> covered) {
  auto face = faces.begin();
  for (const mesh::ElementFace& of_element : mesh::outer_faces(mesh, surface.group, surface.where)) {
    std::vector<mesh::Triangle> triangles;
    mesh::append_triangles(mesh, of_element, triangles);
    const auto close = other.close_to(face->centre(), face->radius());
    ++face;
    for (const mesh::Triangle& triangle : triangles) {
      if (is_covered(triangle, mesh.nodes, other, close)) {
        const auto found = std::ranges::lower_bound(mesh.outer_surface(), triangle);
        if (found == mesh.outer_surface().end() || *found != triangle) {
          throw deck::DeckError(surface.where,
                                fmt::format("the group '{}' has a triangle that is not on the surface", surface.group));
        }
        covered[found - mesh.outer_surface().begin()] = 1;
      }
    }
  }
}

}  // namespace

std::vector<char> covered_triangles(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  const std::vector<Index> first_triangle = mesh::offsets(meshes).triangles;
  std::vector<char> covered(first_triangle.back());
  for (const scene::Joint& joint : solids.joints) {
    if (!joint.is_layer()) {
      continue;
    }
    const auto& [one, other] = joint.surfaces;
    const Faces of_one = faces_of(one, joint.name, meshes[one.body], 0);
    const Faces of_other = faces_of(other, joint.name, meshes[other.body], 0);
    const double reach = reach_of(joint, of_one, of_other);
    const auto of_body = [&](std::size_t body) { return std::span(covered).subspan(first_triangle[body]); };
    cover(one, of_one, meshes[one.body], {of_other, reach}, of_body(one.body));
    cover(other, of_other, meshes[other.body], {of_one, reach}, of_body(other.body));
  }
  if (!solids.joints.empty() && std::ranges::count(covered, 1) == std::ssize(covered)) {
    const scene::Joint& joint = solids.joints.front();
    throw deck::DeckError(joint.where,
                          fmt::format("joints.{}: joints cover all of the surface, so it makes no sound", joint.name));
  }
  return covered;
}

}  // namespace idiophone::joints
