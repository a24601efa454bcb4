#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "facing_surface.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/body_materials.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "links.hpp"

namespace idiophone::joints {

namespace {

// In widths of a face: the slice of the softer body that gives way as much as a rigid joint.
constexpr double rigid_slice = 0.01;

/// The smallest Young's modulus of the two bodies' materials, Pa.
double softest_modulus(const scene::Joint& joint, const scene::Solids& solids) {
  const auto of_body = [&](const scene::JoinedSurface& surface) {
    return scene::softest_modulus(solids.bodies[surface.body], solids.materials);
  };
  return std::min(of_body(joint.surfaces[0]), of_body(joint.surfaces[1]));
}

/// Whether a point of a surface lies under a bolt's washer, or there is none.
/// @param normal  unit vector
bool is_under_washer(const Vector3& position, const Vector3& normal, const scene::Joint& joint, double reach) {
  if (!joint.place) {
    return true;
  }
  const Vector3 from_bolt = position - joint.place->at;
  const double along = normal.dot(from_bolt);
  return (from_bolt - along * normal).norm() <= joint.place->radius && std::abs(along) <= joint.place->radius + reach;
}

/// Joins the points of one surface to another.
class Joiner {
 public:
  /// @param points  of quadrature along each side of a face
  Joiner(const scene::Joint& joint, const FacingSurface& second, int points)
      : joint_(joint), second_(second), points_(points) {}

  void join(const SurfaceFace& face, MeshedJoint& joint) const {
    const std::vector<const SurfaceFace*> close = second_.close_to(face.centre(), face.radius());
    if (close.empty()) {
      return;
    }
    for (const auto& [place, weight] : face.quadrature(points_)) {
      const SurfaceFace::Spot spot = face.at(place);
      const double area = spot.normal().norm();
      const Vector3 normal = spot.normal() / area;
      if (!is_under_washer(spot.position, normal, joint_, second_.reach())) {
        continue;
      }
      if (const auto partner = second_.partner_of(spot.position, normal, close)) {
        append(face, spot, weight * area, *partner, joint);
      }
    }
  }

 private:
  static void append(const SurfaceFace& face, const SurfaceFace::Spot& spot, double area,
                     const FacingSurface::Partner& partner, MeshedJoint& joint) {
    JointPoint point{.area = area, .distance = partner.crossing.distance};
    const auto end = [&] { return static_cast<Index>(joint.weights.size()); };
    point.first_begin = end();
    for (std::size_t n = 0; n < face.nodes().size(); ++n) {
      const auto row = static_cast<Eigen::Index>(n);
      joint.weights.push_back({face.nodes()[n], spot.values[row], {spot.slopes(row, 0), spot.slopes(row, 1)}});
    }
    point.second_begin = end();
    for (std::size_t n = 0; n < partner.face->nodes().size(); ++n) {
      joint.weights.push_back(
          {partner.face->nodes()[n], partner.crossing.spot.values[static_cast<Eigen::Index>(n)], {0.0, 0.0}});
    }
    point.end = end();
    joint.points.push_back(point);
  }

  const scene::Joint& joint_;
  const FacingSurface& second_;
  int points_;
};

/// The points are on the surface with the smaller faces: on the other one, the shape functions are smooth between them.
MeshedJoint mesh_layer(const scene::Joint& joint, const scene::Solids& solids, Faces first, Faces second) {
  if (mean_width(second) < mean_width(first)) {
    std::swap(first, second);
  }
  const double width = mean_width(first);
  const FacingSurface facing(second, reach_of(joint, first, second));
  const double rigid = softest_modulus(joint, solids) / (rigid_slice * width);
  const scene::JointStiffness stiffness = joint.stiffness.value_or(scene::JointStiffness{rigid, rigid});
  MeshedJoint meshed{.normal = stiffness.normal,
                     .tangential = stiffness.tangential,
                     .damping = joint.damping,
                     .reach = facing.reach(),
                     .points = {},
                     .weights = {}};
  const Joiner joiner(joint, facing, std::max(first.front().order(), second.front().order()) + 1);
  for (const SurfaceFace& face : first) {
    joiner.join(face, meshed);
  }
  if (meshed.points.empty()) {
    throw deck::DeckError(
        joint.where, fmt::format("joints.{}: no part of the two surfaces{} faces the other within {:.3g} m: move the "
                                 "bodies together, or give a larger reach{}",
                                 joint.name, joint.place ? " under the washer" : "", facing.reach(),
                                 joint.place ? ", a larger radius or smaller elements" : ""));
  }
  return meshed;
}

}  // namespace

std::vector<MeshedJoint> find_joints(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  return find_joints(solids, meshes, held_parts(solids, meshes));
}

std::vector<MeshedJoint> find_joints(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                     const HeldParts& held) {
  if (solids.joints.empty()) {
    return {};
  }
  const std::vector<Index> first_node = mesh::offsets(meshes).nodes;
  std::vector<MeshedJoint> joints;
  for (std::size_t number = 0; number < solids.joints.size(); ++number) {
    const scene::Joint& joint = solids.joints[number];
    const auto faces = [&](std::size_t side) {
      const scene::JoinedSurface& surface = joint.surfaces[side];
      return faces_of(surface, joint.name, meshes[surface.body], first_node[surface.body]);
    };
    if (joint.is_layer()) {
      joints.push_back(mesh_layer(joint, solids, faces(0), faces(1)));
      joints.back().joint = number;
    } else {
      std::ranges::move(mesh_link(joint, number, softest_modulus(joint, solids), meshes, first_node, held[number]),
                        std::back_inserter(joints));
    }
  }
  return joints;
}

}  // namespace idiophone::joints
