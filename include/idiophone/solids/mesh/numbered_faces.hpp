#pragma once
// Faces of parts whose files name none: STEP, BREP, STL and OBJ files.

#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// A face of a part; its group is "face_" and gmsh's number of it.
struct NumberedFace {
  std::string group;
  double area = 0.0;                 ///< m2
  Vector3 normal = Vector3::Zero();  ///< mean, outwards: shorter than 1 if the face is curved, zero if it is closed
  Vector3 low = Vector3::Zero();     ///< corner of its box, m
  Vector3 high = Vector3::Zero();    ///< the opposite one, m
};

/// The faces of a mesh, ascending by their numbers; none of a .geo or .msh file, which has groups of its own.
/// @param body  whose mesh it is
[[nodiscard]] std::vector<NumberedFace> numbered_faces(const Mesh& mesh, const scene::Body& body);

/// Adds the groups that a body's deck describes instead of naming them: "normal 0 0 -1", all faces whose normal has
/// this direction within 5 degrees, and that are flat; "box 0 0 0 1 1 0.1", all faces between two corners (m), which
/// may be exceeded by 1e-6 of the part's size; "faces 3 4", the faces with these numbers. Adds none where there is no
/// such face.
void add_described_groups(Mesh& mesh, const scene::Body& body);

}  // namespace idiophone::mesh
