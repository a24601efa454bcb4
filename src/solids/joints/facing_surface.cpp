#include "facing_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::joints {

std::vector<mesh::ElementFace> element_faces_of(const scene::JoinedSurface& surface, const std::string& joint,
                                                const mesh::Mesh& mesh) {
  std::vector<mesh::ElementFace> faces = mesh::outer_faces(mesh, surface.group, surface.where);
  if (faces.empty()) {
    throw deck::DeckError(surface.where,
                          fmt::format("joints.{}: the group '{}' has no faces on the outside of the body: name a "
                                      "Physical Surface of gmsh",
                                      joint, surface.group));
  }
  return faces;
}

Faces faces_of(const scene::JoinedSurface& surface, const std::string& joint, const mesh::Mesh& mesh,
               Index first_node) {
  Faces faces;
  for (const mesh::ElementFace& face : element_faces_of(surface, joint, mesh)) {
    faces.emplace_back(mesh, face, first_node);
  }
  return faces;
}

double mean_width(const Faces& faces) {
  const double area =
      std::transform_reduce(faces.begin(), faces.end(), 0.0, std::plus<>(), std::mem_fn(&SurfaceFace::area));
  return std::sqrt(area / static_cast<double>(faces.size()));
}

double reach_of(const scene::Joint& joint, const Faces& one, const Faces& other) {
  constexpr double by_default = 0.1;  // widths of the smaller faces
  return joint.reach.value_or(by_default * std::min(mean_width(one), mean_width(other)));
}

std::vector<const SurfaceFace*> FacingSurface::close_to(const Vector3& centre, double radius) const {
  std::vector<const SurfaceFace*> close;
  for (const SurfaceFace& face : faces_) {
    if ((centre - face.centre()).norm() <= radius + face.radius() + reach_) {
      close.push_back(&face);
    }
  }
  return close;
}

std::optional<FacingSurface::Partner> FacingSurface::partner_of(const Vector3& position, const Vector3& normal,
                                                                const std::vector<const SurfaceFace*>& faces) const {
  std::optional<Partner> nearest;
  double smallest = reach_;
  for (const SurfaceFace* face : faces) {
    const auto crossing = face->crossing(position, normal);
    const bool is_nearer =
        crossing && (nearest ? std::abs(crossing->distance) < smallest : std::abs(crossing->distance) <= smallest);
    if (is_nearer && crossing->spot.normal().dot(normal) < 0) {
      nearest = {face, *crossing};
      smallest = std::abs(crossing->distance);
    }
  }
  return nearest;
}

}  // namespace idiophone::joints
