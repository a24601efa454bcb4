#pragma once
// Which decks get their meshes in parts.

#include <mpi.h>

#include "idiophone/scene/scene.hpp"

namespace idiophone::bodies {

/// Whether the ranks read parts of the meshes (mesh/meshes_in_parts.hpp): all meshes can be read so, nothing in the
/// scene needs the modes of a whole body or surfaces along which it breaks, and there are many elements. PETSc's
/// option -meshes_in_parts yes or no replaces the last condition. The same on all ranks. Collective.
[[nodiscard]] bool reads_in_parts(const scene::Scene& scene, MPI_Comm communicator);

}  // namespace idiophone::bodies
