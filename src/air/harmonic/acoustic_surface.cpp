#include "idiophone/air/harmonic/acoustic_surface.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/contact/outline.hpp"
#include "idiophone/solids/joints/covered_triangles.hpp"
#include "idiophone/solids/joints/exposed_surface.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::harmonic {

namespace {

/// Adds triangles whose vertices are named by keys.
template <class Key>
class SurfaceJoiner {
 public:
  explicit SurfaceJoiner(harmonic::Boundary& boundary) : boundary_(boundary) {}

  void add(const std::array<Key, 3>& keys, const std::array<Vector3, 3>& places) {
    std::array<Index, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [entry, is_new] = numbers_.try_emplace(keys.at(c), static_cast<Index>(boundary_.vertices.size()));
      if (is_new) {
        boundary_.vertices.push_back(places.at(c));
      }
      triangle.at(c) = entry->second;
    }
    boundary_.triangles.push_back(triangle);
  }

 private:
  harmonic::Boundary& boundary_;
  std::map<Key, Index> numbers_;
};

/// @throws deck::DeckError, pointing at the first joint, where the surface has an edge with one triangle
void refuse_open_surface(const joints::ExposedSurface& surface, const scene::Solids& assembly) {
  if (!joints::is_closed(surface.triangles)) {
    const scene::Joint& joint = assembly.joints.front();
    throw deck::DeckError(
        joint.where,
        fmt::format("joints.{}: boundary elements need a closed surface, and that of {} and the bodies joined to it is "
                    "open at the borders of joints: leave no gap, and let the meshes meet vertex by vertex there",
                    joint.name, assembly.bodies.front().name));
  }
}

/// @param assembly  a body, or all that joints tie together
void add_bodies(AcousticSurface& surface, const scene::Solids& assembly) {
  const std::vector<mesh::Mesh> meshes = mesh::read_meshes(assembly.bodies);
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  const joints::ExposedSurface exposed = joints::exposed_surface(part, joints::covered_triangles(assembly, meshes));
  refuse_open_surface(exposed, assembly);
  SurfaceJoiner<Index> joiner(surface.boundary);
  const auto place = [&](Index vertex) { return part.reference[exposed.nodes[vertex]]; };
  for (const auto& [a, b, c] : exposed.triangles) {
    joiner.add({a, b, c}, {place(a), place(b), place(c)});
  }
  ++surface.bodies;
  surface.parts.push_back(assembly.bodies.front().name);
  surface.first_triangle.push_back(static_cast<Index>(surface.boundary.triangles.size()));
}

void add_obstacle(AcousticSurface& surface, const scene::Obstacle& obstacle) {
  SurfaceJoiner<std::array<double, 3>> joiner(surface.boundary);
  for (const auto& places : contact::outline(contact::make_shape(obstacle))) {
    std::array<std::array<double, 3>, 3> keys{};
    for (std::size_t c = 0; c < 3; ++c) {
      const Vector3& place = places.at(c);
      keys.at(c) = {place[0], place[1], place[2]};
    }
    joiner.add(keys, places);
  }
  surface.parts.push_back(obstacle.name);
  surface.first_triangle.push_back(static_cast<Index>(surface.boundary.triangles.size()));
}

}  // namespace

AcousticSurface acoustic_surface(const scene::Solids& solids, const std::optional<scene::Floor>& floor) {
  AcousticSurface surface;
  surface.first_triangle = {0};
  for (const std::vector<std::size_t>& bodies : scene::assemblies(solids)) {
    const scene::Assembly assembly(solids, bodies.front());
    add_bodies(surface, assembly.solids());
  }
  for (const scene::Obstacle& obstacle : solids.obstacles) {
    if (obstacle.shape != scene::Obstacle::Shape::half_space) {
      add_obstacle(surface, obstacle);
    }
  }
  if (floor) {
    surface.boundary.floor = radiation::ReflectingPlane{floor->at, floor->direction, floor->reflection};
  }
  return surface;
}

}  // namespace idiophone::harmonic
