#include "idiophone/solids/eigenmodes/removal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/face_shares.hpp"
#include "idiophone/solids/mesh/faces.hpp"
#include "idiophone/solids/solid/directional_loss.hpp"
#include "idiophone/solids/solid/material_relaxation.hpp"
#include "idiophone/solids/solid/oriented_material.hpp"
#include "nodal_strains.hpp"

namespace idiophone::eigenmodes {

namespace {

/// A face of the surface with its own nodes.
struct OuterFace {
  Index element = 0;
  std::vector<Index> nodes;
  std::vector<Vector3> areas;  ///< [nodes] m2
  double size = 0.0;           ///< m2
};

std::vector<bool> held_nodes(const mesh::Mesh& mesh, const motion::Attachments& attachments) {
  std::vector<bool> held(mesh.nodes.size());
  const motion::Attachments::OfBody& body = attachments.bodies.front();
  for (const auto* patches : {&body.fixed, &body.driven}) {
    for (const mesh::Patch& patch : *patches) {
      for (const Index node : patch.nodes) {
        held[node] = true;
      }
    }
  }
  return held;
}

/// The faces of the surface from which material can be removed.
std::vector<OuterFace> free_faces(const mesh::Mesh& mesh, const std::vector<bool>& held) {
  std::vector<OuterFace> faces;
  for_each_shared_face(mesh, [&](std::span<const mesh::ElementFace> shared) {
    const mesh::ElementFace& face = shared.front();
    OuterFace outer{.element = face.element, .nodes = {}, .areas = {}};
    for (const int place : element::reference(mesh.element).faces[face.side].nodes) {
      outer.nodes.push_back(mesh.element_nodes(face.element)[place]);
    }
    if (shared.size() > 1 || std::ranges::all_of(outer.nodes, [&](Index node) { return held[node]; })) {
      return;
    }
    outer.areas = face_areas(mesh, face);
    for (const Vector3& area : outer.areas) {
      outer.size += area.norm();
    }
    faces.push_back(std::move(outer));
  });
  return faces;
}

/// Means over the faces at a node, by their areas.
struct NodalMeans {
  NodalMeans(std::size_t modes, std::size_t nodes)
      : areas(nodes, Vector3::Zero()), weights(nodes), sums(modes, std::vector<double>(nodes)) {}

  std::vector<Vector3> areas;             ///< [nodes] m2
  std::vector<double> weights;            ///< [nodes] areas of the whole faces at a node, m2
  std::vector<std::vector<double>> sums;  ///< [modes][nodes] of slopes times weights

  [[nodiscard]] RemovalSlopes slopes() const {
    RemovalSlopes result;
    result.slopes.resize(sums.size());
    for (std::size_t node = 0; node < weights.size(); ++node) {
      if (weights[node] > 0) {
        result.nodes.push_back(static_cast<Index>(node));
        result.areas.push_back(areas[node]);
        for (std::size_t m = 0; m < sums.size(); ++m) {
          result.slopes[m].push_back(sums[m][node] / weights[node]);
        }
      }
    }
    return result;
  }
};

double angular_frequency(const Mode& mode) {
  return 2 * std::numbers::pi * mode.frequency;
}

/// Adds the faces of one region.
void add_region(const mesh::Mesh& mesh, Index region, const solid::OrientedMaterial& material,
                const std::vector<OuterFace>& faces, const std::vector<Mode>& modes, NodalMeans& means) {
  std::vector<bool> wanted(mesh.nodes.size());
  for (const OuterFace& face : faces) {
    for (const Index node : face.nodes) {
      wanted[node] = true;
    }
  }
  const std::vector<Eigen::MatrixXd> strains = nodal_strains(mesh, region, wanted, modes);
  const solid::Relaxation relaxation = solid::relaxation_of_loss(material.material.damping);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const double frequency = angular_frequency(modes[m]);  // on which the stiffness depends, by a loss factor
    const solid::StiffnessMatrix stiffness =
        solid::stiffness_matrix(solid::elasticity_at(material, relaxation.modulus(frequency).real()));
    const double square = std::pow(frequency, 2);
    const double cents = 600 / std::numbers::ln2 / square;  // for a change of the square
    for (const OuterFace& face : faces) {
      if (region_of(mesh, face.element) != region) {
        continue;
      }
      for (const Index node : face.nodes) {
        const auto strain = strains[m].col(node);
        const Eigen::Map<const Vector3> motion(&modes[m].shape[3 * static_cast<std::size_t>(node)]);
        const double strained = strain.dot(stiffness * strain);
        const double moving = square * material.material.density * motion.squaredNorm();
        means.sums[m][node] += face.size * cents * (moving - strained);
      }
    }
  }
}

}  // namespace

RemovalSlopes removal_slopes(const scene::Solids& solids, const mesh::Mesh& mesh,
                             const motion::Attachments& attachments, const std::vector<Mode>& modes) {
  const scene::Body& body = solids.bodies.front();
  if (body.prestress) {
    throw deck::DeckError(body.prestress->where,
                          fmt::format("what removed material does is known for bodies without stress, but body '{}' "
                                      "has a prestress",
                                      body.name));
  }
  const std::vector<OuterFace> faces = free_faces(mesh, held_nodes(mesh, attachments));
  NodalMeans means(modes.size(), mesh.nodes.size());
  for (const OuterFace& face : faces) {
    for (std::size_t place = 0; place < face.nodes.size(); ++place) {
      means.areas[face.nodes[place]] += face.areas[place];
      means.weights[face.nodes[place]] += face.size;
    }
  }
  const std::vector<solid::OrientedMaterial> materials = solid::oriented_materials(body, solids.materials);
  for (std::size_t region = 0; region < materials.size(); ++region) {
    add_region(mesh, static_cast<Index>(region), materials[region], faces, modes, means);
  }
  return means.slopes();
}

}  // namespace idiophone::eigenmodes
