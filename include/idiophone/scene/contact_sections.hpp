#pragma once
// Obstacles and contacts of a deck.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/friction/law.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/meshing_settings.hpp"

namespace idiophone::scene {

/// A rigid, fixed and silent solid in contact with bodies.
struct Obstacle {
  enum class Shape {
    half_space,  ///< everything behind a plane
    box,         ///< with edges along x, y and z, rotated by `rotation`
    sphere,
    cylinder,
    surface  ///< the inside of a closed triangulated surface, or a mesh of tetrahedra
  };
  std::string name;
  Shape shape = Shape::half_space;
  Vector3 at = Vector3::Zero();          ///< m; half_space: a point of its plane; box, sphere, cylinder: the centre;
                                         ///< surface: position of the file's origin
  Vector3 direction = Vector3::UnitZ();  ///< unit vector; half_space: its outward normal; cylinder: its axis
  Vector3 size = Vector3::Zero();        ///< box: lengths of its edges, m
  double radius = 0.0;                   ///< sphere, cylinder, m
  double length = 0.0;                   ///< cylinder, m
  Vector3 rotation = Vector3::Zero();    ///< box: axis times angle, rad
  std::filesystem::path mesh;            ///< surface: as Body::mesh
  std::optional<std::string> object;     ///< surface: as Body::object
  std::map<std::string, double> parameters;  ///< surface: as Body::parameters
  MeshingSettings meshing;                   ///< surface
  deck::Location where;
  deck::Location mesh_where;
  deck::Location object_where;
  std::map<std::string, deck::Location> parameters_where;
};

/// Coulomb friction: a contact sticks while the tangential force is below `sticking` times the normal one, and then
/// slides under `sliding` times it. 0 <= sliding <= sticking.
struct Friction {
  double sticking = 0.0;
  double sliding = 0.0;
  std::optional<friction::Law> memory{};  ///< friction with memory in place of Coulomb's; the load is the normal force
};

/// A contact between two bodies, between a body and an obstacle, or of a body with itself. Other pairs pass through
/// each other.
struct Contact {
  std::string name;
  std::size_t body = 0;                 ///< index into Scene::bodies
  std::optional<std::size_t> other;     ///< index into Scene::bodies, `body` if it touches itself; none for an obstacle
  std::optional<std::size_t> obstacle;  ///< index into Scene::obstacles
  Friction friction;
  double damping = 0.0;             ///< relaxation time: pressure = stiffness (depth + damping * its rate), s
  std::optional<double> stiffness;  ///< pressure per depth of overlap, Pa/m; chosen by the program if omitted
  deck::Location where;
};

}  // namespace idiophone::scene
