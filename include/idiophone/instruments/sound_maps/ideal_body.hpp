#pragma once
// Bodies that are no solids of finite elements: those of van den Doel and Pai 1996. They have sound maps only.

#include <array>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::sound_maps {

/// A body in an infinite rigid wall, the plane z = 0 before it is put in its place. It moves along z.
struct IdealBody {
  enum class Type {
    membrane,  ///< of any polygon, or a disc; held at its rim
    string,    ///< along x from 0 to `length`, held at both ends
    bar,       ///< likewise, with bending stiffness
    plate      ///< from 0 to `length` along x and from 0 to `width` along y, simply supported
  };
  enum class Ends { supported, free, clamped, clamped_free };

  std::string name;
  Type type = Type::membrane;
  std::vector<std::array<double, 2>> polygon;  ///< of a membrane: corners in order, m; empty for a disc
  double radius = 0.0;                         ///< of a disc about the origin, m
  double size = 0.0;                           ///< of the elements of a membrane, m
  double length = 0.0;                         ///< m
  double width = 0.0;                          ///< of what radiates, m
  Ends ends = Ends::supported;                 ///< of a bar
  double tension = 0.0;                        ///< N of a string or bar, N/m of a membrane or plate
  double density = 0.0;                        ///< kg/m of a string or bar, kg/m2 of a membrane or plate
  double stiffness = 0.0;                      ///< bending stiffness: E I of a bar, N m2; D of a plate, N m
  double friction = 0.0;                       ///< tan(phi): a mode decays as exp(-pi f tan(phi) t)
  Vector3 position = Vector3::Zero();          ///< where its origin is put, m
  deck::Location where;
};

}  // namespace idiophone::sound_maps
