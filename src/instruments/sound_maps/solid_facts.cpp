#include "solid_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "idiophone/scene/large_amplitudes.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::sound_maps {

namespace {

/// Groups and the axes in which they are held, in alphabetical order: "clamp xyz, foot z"; "nothing" if there are none.
std::string held_groups(const scene::Body& body) {
  std::vector<std::string> groups;
  const auto add = [&](const std::string& group, const scene::Axes& axes) {
    std::string& text = groups.emplace_back(group + " ");
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      text += axes.at(axis) ? std::string(1, "xyz"[axis]) : "";
    }
  };
  for (const scene::FixedGroup& fixed : body.fixed) {
    add(fixed.group, fixed.axes);
  }
  for (const scene::DrivenGroup& driven : body.driven) {
    add(driven.group, driven.axes);
  }
  std::ranges::sort(groups);
  return groups.empty() ? "nothing" : fmt::format("{}", fmt::join(groups, ", "));
}

/// Nodes of the groups that are held or driven.
std::vector<Index> held_nodes(const scene::Body& body, const mesh::Mesh& mesh) {
  std::vector<Index> nodes;
  const auto add = [&](const auto& group) {
    const std::vector<Index>& of_group = mesh::find_group(mesh, group.group, group.where);
    nodes.insert(nodes.end(), of_group.begin(), of_group.end());
  };
  std::ranges::for_each(body.fixed, add);
  std::ranges::for_each(body.driven, add);
  return nodes;
}

/// Of some nodes: cos(k.r) and sin(k.r) for some vectors k that are no multiples of each other and lie askew, so that
/// another mesh, or this one turned or mirrored, has other means.
Eigen::Matrix<double, 6, 2> mean_waves(const std::vector<Index>& nodes, const mesh::Mesh& mesh,
                                       const MeshShape& shape) {
  Eigen::Matrix<double, 6, 3> waves;
  waves << 1.1, 0.7, 0.4, -0.6, 1.3, 0.9, 0.5, -1.2, 1.7, 2.9, 1.6, -2.2, -3.1, 2.7, 3.8, 4.3, -5.2, 4.9;
  Eigen::Matrix<double, 6, 2> sum = Eigen::Matrix<double, 6, 2>::Zero();
  for (const Index node : nodes) {
    const Eigen::Array<double, 6, 1> phase = waves * (mesh.nodes[node] - shape.middle) / shape.size;
    sum.col(0) += phase.cos().matrix();
    sum.col(1) += phase.sin().matrix();
  }
  return sum / std::max(1.0, static_cast<double>(nodes.size()));
}

MeshShape shape_of(const scene::Body& body, const mesh::Mesh& mesh) {
  MeshShape shape{.kind = fmt::format("{}, {} nodes, {} elements", element::name(mesh.element), mesh.nodes.size(),
                                      mesh.element_count())};
  const auto count = static_cast<double>(mesh.nodes.size());
  for (const Vector3& node : mesh.nodes) {
    shape.middle += node / count;
  }
  double square = 0.0;
  for (const Vector3& node : mesh.nodes) {
    square += (node - shape.middle).squaredNorm() / count;
  }
  shape.size = std::sqrt(square);
  std::vector<Index> all(mesh.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  shape.pattern << mean_waves(all, mesh, shape), mean_waves(held_nodes(body, mesh), mesh, shape);
  return shape;
}

/// Whether all of the bodies consist of one material.
bool has_one_material(std::span<const scene::Body> bodies) {
  return std::ranges::all_of(bodies, [&](const scene::Body& body) {
    return body.regions.empty() && body.material == bodies.front().material;
  });
}

}  // namespace

void add_facts(SoundMap& map, const scene::Scene& scene, std::span<const scene::Body> bodies) {
  const scene::Material& material = scene.materials[bodies.front().material];
  map.name = scene.name;
  map.body = bodies.front().name;
  map.kind = "solid";
  map.deck_text = scene.deck_text;
  map.overrides = scene.overrides;
  if (has_one_material(bodies)) {
    map.material = {.name = material.name,
                    .density = material.density,
                    .young = material.young,
                    .poisson = material.is_isotropic() ? material.poisson : 0.0};
  }
  map.air_density = scene.radiation.air.density;
  map.air_speed = scene.radiation.air.speed;
}

std::string why_not_scalable(const scene::Body& body) {
  if (!body.regions.empty()) {
    return "it has several materials";
  }
  if (body.prestress) {
    return "it has a prestress";
  }
  if (!body.supports.empty()) {
    return "it has supports, whose springs stay as stiff as they are";
  }
  if (body.mass_scaling) {
    return "it has mass_scaling";
  }
  if (scene::has_large_amplitudes(body)) {
    return "it has large_amplitudes";
  }
  return "";
}

ScalableModes scalable_modes(const scene::Scene& scene, const scene::Body& body, const mesh::Mesh& mesh) {
  return {.mesh = mesh.hash,
          .mesh_shape = shape_of(body, mesh),
          .held = held_groups(body),
          .stiffness = solid::stiffness_matrix(solid::elasticity(scene.materials[body.material], body.material_axes())),
          .lossless_frequency = {}};
}

}  // namespace idiophone::sound_maps
