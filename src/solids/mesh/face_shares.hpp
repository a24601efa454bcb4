#pragma once
// How a constant stress acts on the nodes of a face.

#include <vector>

#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

/// The share that each node of a face has of the force of a constant stress on it: the integral of its shape function
/// over the face, divided by the area. [nodes of the face, as element::Face has them]
[[nodiscard]] std::vector<double> face_shares(const Mesh& mesh, const ElementFace& face);

}  // namespace idiophone::mesh
