#include "basis_of_modes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::eigenmodes {

modal_bodies::ModalBasis basis_of(const Modes& found, const motion::Dynamics& dynamics, std::size_t bodies) {
  modal_bodies::ModalBasis basis;
  basis.is_free = found.rigid_motions > 0;
  for (std::size_t body = 0; body < bodies; ++body) {
    const std::span<const double> masses = dynamics.model(body).masses();
    basis.masses.insert(basis.masses.end(), masses.begin(), masses.end());
  }
  for (const Mode& mode : found.modes) {
    const double frequency = 2 * std::numbers::pi * mode.frequency;
    basis.frequencies.push_back(frequency);
    basis.decay_rates.push_back(mode.damping_ratio * frequency);
    basis.shapes.insert(basis.shapes.end(), mode.shape.begin(), mode.shape.end());
  }
  return basis;
}

std::vector<Vector3> normals_at(std::span<const Index> nodes, const mesh::Mesh& mesh) {
  std::vector<Vector3> normals(mesh.nodes.size(), Vector3::Zero());
  for (const auto& [i, j, k] : mesh.surface) {
    const Vector3 area = (mesh.nodes[j] - mesh.nodes[i]).cross(mesh.nodes[k] - mesh.nodes[i]);
    for (const Index node : {i, j, k}) {
      normals[node] += area;
    }
  }
  std::vector<Vector3> chosen;
  std::ranges::transform(nodes, std::back_inserter(chosen), [&](Index node) {
    return normals[node].isZero(0.0) ? Vector3(Vector3::UnitZ()) : Vector3(normals[node].normalized());
  });
  return chosen;
}

double thickness_of(const scene::Solids& solids, const scene::Body& body, const mesh::Mesh& mesh,
                    std::span<const double> masses) {
  const double volume = body.regions.empty() ? std::accumulate(masses.begin(), masses.end(), 0.0) /
                                                   solids.materials[body.material].density
                                             : mesh::statistics(mesh).volume;
  double twice_area = 0.0;
  for (const auto& [i, j, k] : mesh.surface) {
    twice_area += (mesh.nodes[j] - mesh.nodes[i]).cross(mesh.nodes[k] - mesh.nodes[i]).norm();
  }
  return 4 * volume / twice_area;
}

ShiftedStiffness invertible_stiffness(const Operators& operators, const Modes& found) {
  return {operators, found.rigid_motions > 0 ? std::pow(2 * std::numbers::pi * found.shift, 2) : 0.0};
}

}  // namespace idiophone::eigenmodes
