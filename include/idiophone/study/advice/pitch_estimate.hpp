#pragma once
// What the mesh does to the pitch of a small body, estimated before a run.

#include <optional>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::advice {

/// The lowest modes of a body that strain it: not its rigid motions on soft supports.
struct PitchEstimate {
  std::vector<double> frequencies;  ///< [modes] Hz
  std::vector<double> mesh_errors;  ///< [modes] cents by which the mesh makes them too high (eigenmodes::mesh_errors())
};

/// Finds the lowest modes by themselves and estimates their errors, on this rank.
/// @param body  index into Scene::bodies
/// @param mesh  of that body
/// @return none where that takes more than a few seconds of one core, where the body has not so many modes, or where a
///         curved element can't be divided
[[nodiscard]] std::optional<PitchEstimate> pitch_estimate(const scene::Scene& scene, std::size_t body,
                                                          const mesh::Mesh& mesh);

}  // namespace idiophone::advice
