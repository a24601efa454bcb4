#pragma once
// Surfaces of triangles that gmsh can't fill.

#include <string>
#include <vector>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// Puts a closed surface around the present model's triangles in their place, with edges that suit the request's
/// `size`. Where the request has no gap, it tries wider ones until the surface has an inside.
/// @return what was done, for the user
/// @throws Refusal when the surface has no inside, or would cross itself
[[nodiscard]] std::vector<std::string> wrap_triangles(const mesh::MeshingRequest& request);

/// Says why gmsh can't fill the present model's triangles.
/// @param scale  metres for each unit of length
/// @throws Refusal when they cross each other, with the place; std::runtime_error when they do not
[[noreturn]] void explain_failure(double scale);

}  // namespace idiophone::mesher
