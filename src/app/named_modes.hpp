#pragma once
// The kinds of modes that `idiophone modes` has found.

#include <mpi.h>

#include <string>
#include <vector>

#include "idiophone/app/body_modes.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::app {

/// [modes] of a body, or of an assembly of bodies, on all ranks; empty texts for unknown ones. Collective.
/// @param scene   of the bodies that have the modes
/// @param meshes  of them, on rank 0
[[nodiscard]] std::vector<std::string> kinds_of(const BodyModes& modes, const scene::Scene& scene,
                                                const std::vector<mesh::Mesh>& meshes, MPI_Comm communicator);

}  // namespace idiophone::app
