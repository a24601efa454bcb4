#pragma once
// Bodies that are no solids of finite elements: those of van den Doel and Pai 1996. They have sound maps only.

#include <array>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/eigenmodes/plate.hpp"

namespace idiophone::sound_maps {

/// A body in an infinite rigid wall, the plane z = 0 before it is put in its place. It moves along z.
struct IdealBody {
  enum class Type {
    membrane,  ///< of any polygon, or a disc, with holes; held at its rims
    string,    ///< along x from 0 to `length`, held at both ends
    bar,       ///< likewise, with bending stiffness
    plate      ///< of any polygon, or a disc, with holes
  };
  enum class Ends { supported, free, clamped, clamped_free };

  std::string name;
  Type type = Type::membrane;
  mesh::PlaneRegion region;  ///< of a membrane or plate; the circle of a disc is about the origin
  double size = 0.0;         ///< of the elements of a membrane or plate, m
  std::vector<std::vector<eigenmodes::PlateEdge>> edges;  ///< of a plate: [contours of the region][sides]
  double poisson = 0.3;                                   ///< of a plate, 1
  double length = 0.0;                                    ///< of a string or bar, and of a rectangular plate; else 0, m
  double width = 0.0;                                     ///< of what radiates, m; likewise
  Ends ends = Ends::supported;                            ///< of a bar
  double tension = 0.0;                                   ///< N of a string or bar, N/m of a membrane or plate
  double density = 0.0;                                   ///< kg/m of a string or bar, kg/m2 of a membrane or plate
  std::string tension_formula;  ///< of a membrane, by x and y (m): takes the place of `tension` where it is not empty
  std::string density_formula;  ///< likewise
  std::vector<Vector3> tension_points;  ///< of a membrane: rows of x, y (m) and the tension there; take the place of
                                        ///< `tension` where there are any
  std::vector<Vector3> density_points;  ///< likewise
  double stiffness = 0.0;               ///< bending stiffness: E I of a bar, N m2; D of a plate, N m
  double friction = 0.0;                ///< tan(phi): a mode decays as exp(-pi f tan(phi) t)
  Vector3 position = Vector3::Zero();   ///< where its origin is put, m
  deck::Location where;
};

}  // namespace idiophone::sound_maps
