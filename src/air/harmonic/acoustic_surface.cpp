#include "idiophone/air/harmonic/acoustic_surface.hpp"

#include <array>
#include <map>

#include "idiophone/solids/contact/outline.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

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

}  // namespace idiophone::harmonic
