#include "known_modes.hpp"

#include <numbers>
#include <stdexcept>

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

/// Of the nodes of the mesh before its refinement.
std::vector<Vector3> shape_of_corners(const std::vector<double>& shape, const mesh::RefinedMesh& refined,
                                      std::size_t corners) {
  std::vector<Vector3> displacements(corners);
  for (std::size_t node = 0; node < refined.parents.size(); ++node) {
    if (const std::vector<mesh::Parent>& parents = refined.parents[node]; parents.size() == 1) {
      displacements[parents[0].node] = Eigen::Map<const Vector3>(&shape[3 * node]);
    }
  }
  return displacements;
}

}  // namespace

std::vector<proxies::KnownMode> known_modes(const scene::Solids& solids, std::size_t body, const mesh::Mesh& mesh,
                                            std::size_t count) {
  const mesh::RefinedMesh refined = mesh::refined(mesh);
  const scene::Body quadratic = as_proxy(solids.bodies[body], refined.mesh.element);
  scene::Solids alone = solids.alone(body);
  alone.bodies = {&quadratic, 1};
  const mesh::Part part = mesh::distribute({refined.mesh}, MPI_COMM_SELF);
  const eigenmodes::Modes found = eigenmodes::find_modes(
      alone, part, motion::attach(alone, {refined.mesh}),
      {.count = static_cast<int>(count), .mass = eigenmodes::MassMatrix::consistent}, MPI_COMM_SELF);
  if (found.rigid_motions != (quadratic.fixed.empty() ? 6 : 0)) {
    throw std::runtime_error("it is neither free nor held in all directions");
  }
  const std::vector<std::vector<double>> shapes = eigenmodes::whole_shapes(found, part, MPI_COMM_SELF);
  std::vector<proxies::KnownMode> modes;
  for (std::size_t m = 0; m < found.modes.size(); ++m) {
    modes.push_back({.angular_frequency = 2.0 * std::numbers::pi * found.modes[m].lossless_frequency,
                     .shape = shape_of_corners(shapes[m], refined, mesh.nodes.size())});
  }
  return modes;
}

}  // namespace idiophone::proxy_bodies
