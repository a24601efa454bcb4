#pragma once
// Blocks and bars of rubber that break along surfaces, on one rank.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "idiophone/foundation/element/reference.hpp"
#include "laboratory.hpp"

namespace idiophone::motion {

inline constexpr double bar_young = 1e6, bar_density = 1000;  // Pa, kg/m3
inline const double bar_speed = std::sqrt(bar_young / bar_density);
inline constexpr double never = 1e15;  // Pa

using Inside = std::function<bool(const Vector3&)>;

inline Inside across_x(double place) {
  return [place](const Vector3& node) { return std::abs(node.x() - place) < 1e-9; };
}
inline Inside across_y(double place) {
  return [place](const Vector3& node) { return std::abs(node.y() - place) < 1e-9; };
}

/// @param strength  Pa
inline scene::FractureSurface brittle(double strength) {
  scene::FractureSurface law;
  law.strength = strength;
  return law;
}

/// The faces of elements all of whose corners are on a surface: what a group of linear triangles has.
inline std::vector<mesh::Triangle> triangles_on(const mesh::Mesh& mesh, const Inside& surface) {
  std::vector<mesh::Triangle> triangles;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const auto nodes = mesh.element_nodes(element);
    for (const element::Face& face : element::reference(mesh.element).faces) {
      if (std::ranges::all_of(face.corners, [&](int corner) { return surface(mesh.nodes[nodes[corner]]); })) {
        triangles.push_back({nodes[face.corners[0]], nodes[face.corners[1]], nodes[face.corners[2]]});
      }
    }
  }
  return triangles;
}

/// A block of rubber that breaks along surfaces by one law.
inline Laboratory breakable(mesh::Mesh mesh, const std::vector<Inside>& surfaces, const scene::FractureSurface& law) {
  scene::Body body;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const std::string name = "surface" + std::to_string(s);
    body.fracture.push_back(law);
    body.fracture.back().group = name;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      if (surfaces[s](mesh.nodes[node])) {
        mesh.groups[name].push_back(static_cast<Index>(node));
      }
    }
    mesh.group_triangles[name] = triangles_on(mesh, surfaces[s]);
  }
  Laboratory lab(surfaces.empty() ? mesh : mesh::divide(mesh, body));
  lab.scene.bodies[0].fracture = body.fracture;
  lab.attachments.bodies[0].fracture = lab.mesh.fracture_faces;
  return lab;
}

inline constexpr double cell = 0.005;            // m, of a bar, as wide as one cell
inline constexpr double bar_area = cell * cell;  // m2
inline constexpr double bar_step = 5e-6;         // s: a third of the stable step

inline const std::vector<element::Type> all_elements = {element::tet4, element::tet10, element::hex(3, 2)};

/// A bar along x without lateral contraction, so that its waves are those of one dimension.
inline Laboratory bar(double length, double break_at, const scene::FractureSurface& law,
                      element::Type element = element::tet10) {
  const int cells = static_cast<int>(std::lround(length / cell));
  Laboratory lab =
      breakable(support::block_mesh(element, {length, cell, cell}, {cells, 1, 1}), {across_x(break_at)}, law);
  lab.scene.materials[0].poisson = 0.0;
  return lab;
}

/// Displacement, m, and velocity, m/s, along x at a place.
using Wave = std::function<std::array<double, 2>(double)>;

inline std::vector<double> rows_of(const Laboratory& lab, const Wave& wave) {
  std::vector<double> rows;
  for (const Vector3& node : lab.mesh.nodes) {
    const auto [u, v] = wave(node.x());
    rows.insert(rows.end(), {u, 0, 0, v, 0, 0});
  }
  return rows;
}

inline double broken_area(const Laboratory& lab) {
  return lab.motion->dynamics().fractures()[0].broken_area();
}

/// [nodes] Whether they belong to elements beyond a place.
inline std::vector<char> nodes_beyond(const Laboratory& lab, double place) {
  std::vector<char> beyond(lab.mesh.nodes.size());
  for (Index element = 0; element < lab.mesh.element_count(); ++element) {
    double middle = 0.0;
    for (const Index node : lab.mesh.element_nodes(element)) {
      middle += lab.mesh.nodes[node].x() / element::node_count(lab.mesh.element);
    }
    for (const Index node : lab.mesh.element_nodes(element)) {
      beyond[node] = middle > place ? 1 : beyond[node];
    }
  }
  return beyond;
}

/// Of these nodes, along x, kg m/s.
inline double momentum_beyond(const Laboratory& lab, double place) {
  const std::vector<char> beyond = nodes_beyond(lab, place);
  const auto masses = lab.motion->dynamics().model(0).masses();
  double sum = 0.0;
  for (std::size_t node = 0; node < beyond.size(); ++node) {
    sum += beyond[node] != 0 ? masses[node] * lab.motion->state()[node].velocity[0] : 0.0;
  }
  return sum;
}

/// Steps until a part of the area is broken.
inline int steps_until(const Laboratory& lab, double broken) {
  int steps = 0;
  while (broken_area(lab) < broken && steps < 10000) {
    lab.advance(1);
    ++steps;
  }
  return steps;
}

inline double energy_of(const Laboratory& lab) {
  const BodyMotion motion = lab.observe();
  return motion.kinetic + motion.elastic;
}

}  // namespace idiophone::motion
