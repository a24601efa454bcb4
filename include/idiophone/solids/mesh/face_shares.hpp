#pragma once
// How the nodes of a face share its area.

#include <vector>

#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

/// The share that each node of a face has of the force of a constant stress on it: the integral of its shape function
/// over the face, divided by the area. [nodes of the face, as element::Face has them]
[[nodiscard]] std::vector<double> face_shares(const Mesh& mesh, const ElementFace& face);

/// The part of the face's area vector that belongs to each node: the integral of its shape function times the normal,
/// outwards. [nodes of the face, as element::Face has them] m2
[[nodiscard]] std::vector<Vector3> face_areas(const Mesh& mesh, const ElementFace& face);

}  // namespace idiophone::mesh
