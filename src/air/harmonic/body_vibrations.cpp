#include "idiophone/air/harmonic/body_vibrations.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>

#include "given_velocities.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/joints/covered_triangles.hpp"
#include "idiophone/solids/joints/exposed_surface.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::harmonic {

namespace {

/// Moves one part; all else is at rest.
/// @param velocity  of a corner of one of the part's triangles, by the triangle's place within the part
void move(Vibration& vibration, const AcousticSurface& surface, std::size_t part,
          const std::function<ComplexVector(std::size_t triangle, std::size_t corner)>& velocity) {
  const harmonic::Boundary& boundary = surface.boundary;
  vibration.velocity.assign(boundary.vertices.size(), ComplexVector::Zero());
  vibration.normal_velocity.assign(3 * boundary.triangles.size(), Complex{});
  const auto first = static_cast<std::size_t>(surface.first_triangle[part]);
  for (auto t = first; t < static_cast<std::size_t>(surface.first_triangle[part + 1]); ++t) {
    const auto& [a, b, c] = boundary.triangles[t];
    const Vector3& corner = boundary.vertices[a];
    const Vector3 normal = (boundary.vertices[b] - corner).cross(boundary.vertices[c] - corner).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const ComplexVector here = velocity(t - first, i);
      vibration.velocity[boundary.triangles[t].at(i)] = here;
      vibration.normal_velocity[3 * t + i] = normal.cast<Complex>().dot(here);
    }
  }
}

}  // namespace

std::vector<Vibration> modal_vibrations(const scene::Solids& solids, std::size_t part, int count,
                                        const AcousticSurface& surface) {
  const scene::Assembly joined(solids, scene::assemblies(solids)[part].front());
  const scene::Solids assembly = joined.solids();
  const std::vector<mesh::Mesh> meshes = mesh::read_meshes(assembly.bodies);
  const mesh::Part mesh = mesh::distribute(meshes, MPI_COMM_SELF);
  const joints::ExposedSurface exposed = joints::exposed_surface(mesh, joints::covered_triangles(assembly, meshes));
  const eigenmodes::Modes found =
      eigenmodes::find_modes(assembly, mesh, motion::attach(assembly, meshes), {.count = count}, MPI_COMM_SELF);
  std::vector<Vibration> vibrations;
  for (const eigenmodes::Mode& mode : found.modes) {
    Vibration& vibration = vibrations.emplace_back();
    vibration.name = fmt::format("mode {}", vibrations.size());
    vibration.frequency = mode.frequency;
    vibration.energy = 0.5;  // unit modal mass, unit modal velocity
    move(vibration, surface, part, [&](std::size_t triangle, std::size_t corner) {
      const Index node = exposed.nodes[exposed.triangles[triangle].at(corner)];
      return ComplexVector(Vector3::Map(&mode.shape[3UL * node]).cast<Complex>());
    });
  }
  return vibrations;
}

std::vector<Vibration> rigid_vibrations(std::size_t part, const std::vector<double>& frequencies,
                                        const AcousticSurface& surface) {
  std::vector<Vibration> vibrations;
  for (const double frequency : frequencies) {
    for (const int axis : {0, 1, 2}) {
      Vibration& vibration = vibrations.emplace_back();
      vibration.name = fmt::format("along {}", "xyz"[axis]);
      vibration.frequency = frequency;
      move(vibration, surface, part,
           [axis](std::size_t, std::size_t) { return ComplexVector(ComplexVector::Unit(axis)); });
    }
  }
  return vibrations;
}

std::vector<Vibration> given_vibrations(std::size_t part, const std::filesystem::path& file,
                                        const AcousticSurface& surface) {
  std::vector<Vibration> vibrations;
  for (const auto& at_frequency : read_velocities(file, surface, part)) {
    const VertexVelocities& velocity = at_frequency.second;
    Vibration& vibration = vibrations.emplace_back();
    vibration.name = "given";
    vibration.frequency = at_frequency.first;
    const auto first = static_cast<std::size_t>(surface.first_triangle[part]);
    move(vibration, surface, part, [&](std::size_t triangle, std::size_t corner) {
      return velocity.at(surface.boundary.triangles[first + triangle].at(corner));
    });
  }
  return vibrations;
}

}  // namespace idiophone::harmonic
