#include "links.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "anchor.hpp"
#include "facing_surface.hpp"
#include "idiophone/foundation/bounding_box.hpp"
#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::joints {

namespace {

constexpr double rigid_link = 100;       // N/m, in moduli times the width of the part that is held
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

/// A spring may be long: its place need not be near both surfaces.
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

/// The faces around the one that is nearest to a place.
std::vector<mesh::ElementFace> faces_around(const scene::PatchPlace& place, const mesh::Mesh& mesh,
                                            const std::vector<mesh::ElementFace>& faces) {
  Faces curved;
  for (const mesh::ElementFace& face : faces) {
    curved.emplace_back(mesh, face, 0);
  }
  const auto nearest = std::ranges::min_element(
      curved, {}, [&](const SurfaceFace& face) { return (face.centre() - place.at).squaredNorm(); });
  std::vector<mesh::ElementFace> around;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if ((curved[f].centre() - nearest->centre()).norm() <= place.radius) {
      around.push_back(faces[f]);
    }
  }
  return around;
}

Anchor anchor_of(const scene::Joint& joint, const scene::JoinedSurface& surface, const mesh::Mesh& mesh,
                 Index first_node) {
  std::vector<mesh::ElementFace> faces = element_faces_of(surface, joint.name, mesh);
  if (joint.place) {
    faces = faces_around(*joint.place, mesh, faces);
  }
  Anchor anchor(mesh, faces, first_node);
  if (anchor.nodes().size() > most_nodes) {
    throw deck::DeckError(surface.where,
                          fmt::format("joints.{}: the elements at '{}' have {} nodes, and springs and hinges hold at "
                                      "most {}: name a smaller surface{}",
                                      joint.name, surface.group, anchor.nodes().size(), most_nodes,
                                      joint.type == scene::JointType::spring ? ", or give at and radius" : ""));
  }
  return anchor;
}

/// Two unit vectors, so that the three are at right angles in their order.
std::array<Vector3, 2> across(const Vector3& direction) {
  const Vector3 first = direction.unitOrthogonal();
  return {first, direction.cross(first)};
}

/// @param first, second  [nodes of the anchor] weights of the points that the link ties together
/// @param line           unit vector: normal of the frame that turns with the first anchor
void append(MeshedJoint& link, const Anchor& one, const std::vector<double>& first, const Anchor& other,
            const std::vector<double>& second, const Vector3& line, double length) {
  const auto [a, b] = across(line);
  const std::vector<double> along_a = one.slopes_along(a), along_b = one.slopes_along(b);
  JointPoint point{.area = 1.0, .distance = length, .first_begin = static_cast<Index>(link.weights.size())};
  for (std::size_t n = 0; n < one.nodes().size(); ++n) {
    link.weights.push_back({one.nodes()[n], first[n], {along_a[n], along_b[n]}});
  }
  point.second_begin = static_cast<Index>(link.weights.size());
  for (std::size_t n = 0; n < other.nodes().size(); ++n) {
    link.weights.push_back({other.nodes()[n], second[n], {0.0, 0.0}});
  }
  point.end = static_cast<Index>(link.weights.size());
  link.points.push_back(point);
}

struct SpringLine {
  Vector3 direction;  ///< unit vector
  double length;      ///< m
};

/// Between the middles; along the mean normal where these are one place. A surface that faces all ways has no such
/// normal, and its mesh moves its middle a little.
/// @throws deck::DeckError where a spring that pulls differently along and across its line has none
SpringLine line_of(const scene::Joint& joint, const Anchor& one, const Anchor& other) {
  constexpr double least_normal = 0.05;                                   // of the mean normal
  constexpr double same_place = 1e-6, same_place_facing_all_ways = 0.05;  // widths
  const Vector3 line = other.middle() - one.middle();
  const bool has_normal = one.normal().norm() > least_normal;
  if (line.norm() > (has_normal ? same_place : same_place_facing_all_ways) * one.width()) {
    return {line.normalized(), line.norm()};
  }
  if (!has_normal && joint.stiffness->normal != joint.stiffness->tangential) {
    throw deck::DeckError(
        joint.where, fmt::format("joints.{}: the middles of '{}' and '{}' are at the same place, and the surfaces face "
                                 "all ways, so that axial and lateral have no direction: give one number as stiffness, "
                                 "or at and radius of the part of the surfaces that the spring holds",
                                 joint.name, joint.surfaces[0].group, joint.surfaces[1].group));
  }
  return {has_normal ? one.normal().normalized() : Vector3::UnitX(), 0.0};
}

void append_spring(MeshedJoint& link, const scene::Joint& joint, const Anchor& one, const Anchor& other) {
  const SpringLine line = line_of(joint, one, other);
  append(link, one, one.shares(), other, other.shares(), line.direction, line.length);
}

void require_near(const Vector3& end, const Anchor& anchor, const scene::Joint& joint,
                  const scene::JoinedSurface& surface) {
  const double distance = (end - anchor.centre()).norm();
  if (distance > farthest_axis * anchor.radius()) {
    throw deck::DeckError(surface.where,
                          fmt::format("joints.{}: the end [{:.6g}, {:.6g}, {:.6g}] of the axis is {:.3g} m from the "
                                      "middle of '{}', which reaches {:.3g} m: let the axis end there, or name a "
                                      "larger surface",
                                      joint.name, end.x(), end.y(), end.z(), distance, surface.group, anchor.radius()));
  }
}

void append_hinge(MeshedJoint& link, const scene::Joint& joint, const Anchor& one, const Anchor& other) {
  const Vector3 line = (joint.axis.end - joint.axis.begin).normalized();
  for (const Vector3& end : {joint.axis.begin, joint.axis.end}) {
    require_near(end, one, joint, joint.surfaces[0]);
    require_near(end, other, joint, joint.surfaces[1]);
    append(link, one, one.weights_at(end), other, other.weights_at(end), line, 0.0);
  }
}

MeshedJoint resistance_to_turning(const scene::Joint& joint, std::size_t number, const Anchor& one,
                                  const Anchor& other) {
  MeshedJoint turning{.joint = number,
                      .resists_turning = true,
                      .normal = joint.turning->stiffness,
                      .damping = joint.turning->damping,
                      .points = {},
                      .weights = {}};
  const auto [first, second] = across((joint.axis.end - joint.axis.begin).normalized());
  JointPoint point{.area = 1.0};
  for (const auto& [anchor, direction] : {std::pair(&one, first), std::pair(&other, second)}) {
    point.second_begin = point.end;  // of the body before
    const std::vector<double> slopes = anchor->slopes_along(direction);
    for (std::size_t n = 0; n < slopes.size(); ++n) {
      turning.weights.push_back({anchor->nodes()[n], 0.0, {slopes[n], 0.0}});
    }
    point.end = static_cast<Index>(turning.weights.size());
  }
  turning.points.push_back(point);
  return turning;
}

}  // namespace

std::vector<MeshedJoint> mesh_link(const scene::Joint& joint, std::size_t number, double modulus,
                                   const std::vector<mesh::Mesh>& meshes, const std::vector<Index>& first_node) {
  const auto anchor = [&](const scene::JoinedSurface& surface) {
    return anchor_of(joint, surface, meshes[surface.body], first_node[surface.body]);
  };
  if (joint.place) {
    require_place_near(joint, meshes);
  }
  const Anchor one = anchor(joint.surfaces[0]), other = anchor(joint.surfaces[1]);
  const double rigid = rigid_link * modulus * std::min(one.width(), other.width());
  const scene::JointStiffness stiffness = joint.stiffness.value_or(scene::JointStiffness{rigid, rigid});
  MeshedJoint link{.joint = number,
                   .normal = stiffness.normal,
                   .tangential = stiffness.tangential,
                   .damping = joint.damping,
                   .points = {},
                   .weights = {}};
  if (joint.type == scene::JointType::hinge) {
    append_hinge(link, joint, one, other);
  } else {
    append_spring(link, joint, one, other);
  }
  std::vector<MeshedJoint> links = {std::move(link)};
  if (joint.turning) {
    links.push_back(resistance_to_turning(joint, number, one, other));
  }
  return links;
}

}  // namespace idiophone::joints
