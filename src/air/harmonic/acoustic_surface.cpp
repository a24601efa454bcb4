#include "idiophone/air/harmonic/acoustic_surface.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <map>

#include "idiophone/solids/contact/outline.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"

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

void add_body(AcousticSurface& surface, const scene::Body& body) {
  const mesh::Mesh mesh = mesh::read_mesh(body);
  SurfaceJoiner<Index> joiner(surface.boundary);
  for (const auto& [a, b, c] : mesh.surface) {
    joiner.add({a, b, c}, {mesh.nodes[a], mesh.nodes[b], mesh.nodes[c]});
  }
  surface.parts.push_back(body.name);
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

/// Moves one part; all else is at rest.
/// @param velocity  of a corner of one of the part's triangles, by the triangle's place within the part
void move(Vibration& vibration, const AcousticSurface& surface, std::size_t part,
          const std::function<Vector3(std::size_t triangle, std::size_t corner)>& velocity) {
  const harmonic::Boundary& boundary = surface.boundary;
  vibration.velocity.assign(boundary.vertices.size(), Vector3::Zero());
  vibration.normal_velocity.assign(3 * boundary.triangles.size(), 0.0);
  const auto first = static_cast<std::size_t>(surface.first_triangle[part]);
  for (auto t = first; t < static_cast<std::size_t>(surface.first_triangle[part + 1]); ++t) {
    const auto& [a, b, c] = boundary.triangles[t];
    const Vector3& corner = boundary.vertices[a];
    const Vector3 normal = (boundary.vertices[b] - corner).cross(boundary.vertices[c] - corner).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 here = velocity(t - first, i);
      vibration.velocity[boundary.triangles[t].at(i)] = here;
      vibration.normal_velocity[3 * t + i] = normal.dot(here);
    }
  }
}

}  // namespace

AcousticSurface acoustic_surface(const scene::Solids& solids, const std::optional<scene::Floor>& floor) {
  AcousticSurface surface;
  surface.first_triangle = {0};
  for (const scene::Body& body : solids.bodies) {
    add_body(surface, body);
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

std::vector<Vibration> modal_vibrations(const scene::Solids& solids, std::size_t body, int count,
                                        const AcousticSurface& surface) {
  const scene::Solids alone = solids.alone(body);
  const std::vector<mesh::Mesh> meshes = {mesh::read_mesh(alone.bodies.front())};
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  const eigenmodes::Modes found =
      eigenmodes::find_modes(alone, part, motion::attach(alone, meshes), {.count = count}, MPI_COMM_SELF);
  std::vector<Vibration> vibrations;
  for (const eigenmodes::Mode& mode : found.modes) {
    Vibration& vibration = vibrations.emplace_back();
    vibration.name = fmt::format("mode {}", vibrations.size());
    vibration.frequency = mode.frequency;
    vibration.energy = 0.5;  // unit modal mass, unit modal velocity
    move(vibration, surface, body, [&](std::size_t triangle, std::size_t corner) {
      const Index node = part.vertices[part.surface[triangle].at(corner)];
      return Vector3(Eigen::Map<const Vector3>(&mode.shape[3UL * node]));
    });
  }
  return vibrations;
}

std::vector<Vibration> rigid_vibrations(std::size_t body, const std::vector<double>& frequencies,
                                        const AcousticSurface& surface) {
  std::vector<Vibration> vibrations;
  for (const double frequency : frequencies) {
    for (const int axis : {0, 1, 2}) {
      Vibration& vibration = vibrations.emplace_back();
      vibration.name = fmt::format("along {}", "xyz"[axis]);
      vibration.frequency = frequency;
      move(vibration, surface, body, [axis](std::size_t, std::size_t) { return Vector3(Vector3::Unit(axis)); });
    }
  }
  return vibrations;
}

}  // namespace idiophone::harmonic
