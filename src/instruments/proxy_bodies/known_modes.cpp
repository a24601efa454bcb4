#include "known_modes.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/whole_shapes.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/refined.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::proxy_bodies {

namespace {

/// What a proxy has of a body: its material, and groups that are fixed.
scene::Body as_proxy(scene::Body body, element::Type element) {
  body.element = element;
  body.supports.clear();
  body.modal.reset();
  body.mass_scaling.reset();
  return body;
}

/// Elements in which the modes are found.
struct FineMesh {
  mesh::Mesh mesh;
  std::vector<Index> nodes;  ///< [nodes of the mesh it is made from] the same places in `mesh`
};

FineMesh finer(const FineMesh& given) {
  mesh::RefinedMesh refined = mesh::refined(given.mesh);
  std::vector<Index> same(given.mesh.nodes.size());
  for (std::size_t node = 0; node < refined.parents.size(); ++node) {
    if (refined.parents[node].size() == 1) {
      same[refined.parents[node][0].node] = static_cast<Index>(node);
    }
  }
  FineMesh fine{.mesh = std::move(refined.mesh), .nodes = {}};
  std::ranges::transform(given.nodes, std::back_inserter(fine.nodes), [&](Index node) { return same[node]; });
  return fine;
}

/// With quadratic elements, which are halved if that costs no more than some seconds.
FineMesh fine_mesh(const mesh::Mesh& mesh) {
  constexpr double most_entries = 1e7;  // of the stiffness matrix
  std::vector<Index> all(mesh.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  const FineMesh quadratic = finer({.mesh = mesh, .nodes = std::move(all)});
  return mesh::refined_entries(quadratic.mesh) <= most_entries ? finer(quadratic) : quadratic;
}

}  // namespace

std::vector<proxies::KnownMode> known_modes(const scene::Solids& solids, std::size_t body, const mesh::Mesh& mesh,
                                            std::size_t count) {
  const FineMesh fine = fine_mesh(mesh);
  const scene::Body quadratic = as_proxy(solids.bodies[body], fine.mesh.element);
  scene::Solids alone = solids.alone(body);
  alone.bodies = {&quadratic, 1};
  const mesh::Part part = mesh::distribute({fine.mesh}, MPI_COMM_SELF);
  const eigenmodes::Modes found = eigenmodes::find_modes(
      alone, part, motion::attach(alone, {fine.mesh}),
      {.count = static_cast<int>(count), .mass = eigenmodes::MassMatrix::consistent}, MPI_COMM_SELF);
  if (found.rigid_motions != (quadratic.fixed.empty() ? 6 : 0)) {
    throw std::runtime_error("it is neither free nor held in all directions");
  }
  const std::vector<std::vector<double>> shapes = eigenmodes::whole_shapes(found, part, MPI_COMM_SELF);
  std::vector<proxies::KnownMode> modes;
  for (std::size_t m = 0; m < found.modes.size(); ++m) {
    proxies::KnownMode& mode = modes.emplace_back();
    mode.angular_frequency = 2.0 * std::numbers::pi * found.modes[m].lossless_frequency;
    for (const Index node : fine.nodes) {
      mode.shape.emplace_back(Eigen::Map<const Vector3>(&shapes[m][3 * static_cast<std::size_t>(node)]));
    }
  }
  return modes;
}

}  // namespace idiophone::proxy_bodies
