#include "held_part.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>

#include "facing_surface.hpp"
#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/each_once.hpp"

namespace idiophone::joints {

namespace {

constexpr std::size_t most_nodes = 500;  // of a body: each of them is tied to each
constexpr double farthest_axis = 3;      // radii of the part that is held
constexpr double farthest_place = 0.25;  // of a spring from the nearer surface, in sizes of its body

/// From a place, m; 0 inside the sphere around one of the faces.
double distance_to(const Faces& faces, const Vector3& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceFace& face : faces) {
    least = std::min(least, (face.centre() - place).norm() - face.radius());
  }
  return std::max(0.0, least);
}

std::vector<Vector3> middles_of(const std::vector<mesh::ElementFace>& faces, const mesh::Mesh& mesh) {
  std::vector<Vector3> middles;
  std::ranges::transform(faces, std::back_inserter(middles),
                         [&](const mesh::ElementFace& face) { return SurfaceFace(mesh, face, 0).centre(); });
  return middles;
}

Vector3 nearest_to(const Vector3& place, const std::vector<Vector3>& middles) {
  return *std::ranges::min_element(middles, {}, [&](const Vector3& middle) { return (middle - place).squaredNorm(); });
}

/// The faces whose middles are within a distance from a centre.
/// @param middles  [faces] m
std::vector<mesh::ElementFace> within(double distance, const Vector3& centre, const std::vector<Vector3>& middles,
                                      const std::vector<mesh::ElementFace>& faces) {
  std::vector<mesh::ElementFace> around;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if ((middles[f] - centre).norm() <= distance) {
      around.push_back(faces[f]);
    }
  }
  return around;
}

/// The faces around the one that is nearest to a place.
std::vector<mesh::ElementFace> faces_around(const scene::PatchPlace& place, const mesh::Mesh& mesh,
                                            const std::vector<mesh::ElementFace>& faces) {
  const std::vector<Vector3> middles = middles_of(faces, mesh);
  return within(place.radius, nearest_to(place.at, middles), middles, faces);
}

/// The faces whose middles lie under the washer; the nearest one where there is none.
std::vector<mesh::ElementFace> faces_under_washer(const scene::PatchPlace& washer, const mesh::Mesh& mesh,
                                                  const std::vector<mesh::ElementFace>& faces) {
  const std::vector<Vector3> middles = middles_of(faces, mesh);
  const double nearest = (nearest_to(washer.at, middles) - washer.at).norm();
  return within(std::max(washer.radius, nearest), washer.at, middles, faces);
}

/// What a joint holds at one of its surfaces.
/// @param end  of the axis of a bolt there; not used otherwise
HeldPart held_part(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                   const mesh::Mesh& mesh) {
  std::vector<mesh::ElementFace> faces = element_faces_of(surface, joint.name, mesh);
  if (joint.place) {
    faces = faces_around(*joint.place, mesh, faces);
  } else if (joint.shank) {
    faces = faces_under_washer({.at = end, .radius = joint.shank->washer, .where = {}}, mesh, faces);
  }
  HeldPart part{.faces = faces, .elements = {}};
  std::ranges::transform(faces, std::back_inserter(part.elements), &mesh::ElementFace::element);
  keep_each_once(part.elements);
  if (const std::size_t nodes = part.nodes(mesh).size(); nodes > most_nodes) {
    throw deck::DeckError(surface.where,
                          fmt::format("joints.{}: the elements at '{}' have {} nodes, and springs, hinges and bolts "
                                      "hold at most {}: {}",
                                      joint.name, surface.group, nodes, most_nodes, how_to_hold_less(joint)));
  }
  return part;
}

/// A spring may be long: its place need not be near both surfaces.
/// @throws deck::DeckError where it is far from both
void require_place_near(const scene::Joint& joint, const std::vector<mesh::Mesh>& meshes) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const scene::JoinedSurface& surface : joint.surfaces) {
    const mesh::Mesh& mesh = meshes[surface.body];
    const double distance = distance_to(faces_of(surface, joint.name, mesh, 0), joint.place->at);
    if (distance <= farthest_place * bounding_box(mesh.nodes).diagonal().norm()) {
      return;
    }
    nearest = std::min(nearest, distance);
  }
  const Vector3& at = joint.place->at;
  throw deck::DeckError(
      joint.place->where,
      fmt::format("joints.{}: the place [{:.6g}, {:.6g}, {:.6g}] is {:.3g} m from the nearer of '{}' "
                  "and '{}', more than a quarter of the size of the body: give a place on one of "
                  "these surfaces, or leave out at and radius",
                  joint.name, at.x(), at.y(), at.z(), nearest, joint.surfaces[0].group, joint.surfaces[1].group));
}

/// @throws deck::DeckError where the end of a bolt's axis is farther from the surface than its washer is wide
void require_washer_on(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                       const mesh::Mesh& mesh) {
  const double distance = distance_to(faces_of(surface, joint.name, mesh, 0), end);
  if (distance > joint.shank->washer) {
    throw deck::DeckError(surface.where,
                          fmt::format("joints.{}: the end [{:.6g}, {:.6g}, {:.6g}] of the axis is {:.3g} m from '{}', "
                                      "more than the radius of the washer: let the axis end on this surface; its first "
                                      "end belongs to the first surface",
                                      joint.name, end.x(), end.y(), end.z(), distance, surface.group));
  }
}

}  // namespace

std::string how_to_hold_less(const scene::Joint& joint) {
  if (joint.shank) {
    return "use larger elements, or a smaller radius of the washers";
  }
  return joint.type == scene::JointType::spring ? "name a smaller surface, or give at and radius"
                                                : "name a smaller surface";
}

std::array<HeldPart, 2> held_by(const scene::Joint& joint, const std::vector<mesh::Mesh>& meshes) {
  const auto& [first, second] = joint.surfaces;
  if (joint.place) {
    require_place_near(joint, meshes);
  } else if (joint.shank) {
    require_washer_on(joint, first, joint.axis.begin, meshes[first.body]);
    require_washer_on(joint, second, joint.axis.end, meshes[second.body]);
  }
  return {held_part(joint, first, joint.axis.begin, meshes[first.body]),
          held_part(joint, second, joint.axis.end, meshes[second.body])};
}

void require_hinge_near(const scene::Joint& joint, const scene::JoinedSurface& surface, const Vector3& end,
                        const Anchor& anchor) {
  const double distance = (end - anchor.centre()).norm();
  if (distance > farthest_axis * anchor.radius()) {
    throw deck::DeckError(surface.where,
                          fmt::format("joints.{}: the end [{:.6g}, {:.6g}, {:.6g}] of the axis is {:.3g} m from the "
                                      "middle of '{}', which reaches {:.3g} m: let the axis end there, or name a "
                                      "larger surface",
                                      joint.name, end.x(), end.y(), end.z(), distance, surface.group, anchor.radius()));
  }
}

}  // namespace idiophone::joints
