#pragma once
// The air that moves along with the modes of a body.

#include <mpi.h>

#include <vector>

#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::app {

/// What the air does to each mode, [modes]; NaN for those that have no air. Empty without air.
struct AirOfModes {
  std::vector<double> shift;            ///< of the frequency, cents
  std::vector<double> radiation_decay;  ///< of the amplitude, by the radiated sound, 1/s
};

/// Gives modes the mass and the resistance of the air: frequencies, damping and shapes. Collective.
/// @param shapes  of the whole mesh, on rank 0: [modes] of [3 x nodes]
/// @param meshes  of the body, on rank 0
/// @param watch   of rank 0; if it ends the work, the modes that are left have no air, as those that the mesh does not
///                resolve
[[nodiscard]] AirOfModes take_air(eigenmodes::Modes& found, const std::vector<std::vector<double>>& shapes,
                                  const std::vector<mesh::Mesh>& meshes, const scene::AirProperties& air,
                                  MPI_Comm communicator, const PartWatch& watch);

/// Warns if the air would lower a mode by more than 2 cents. Call on rank 0.
void warn_of_air(const eigenmodes::Modes& found, const std::vector<std::vector<double>>& shapes, const mesh::Mesh& mesh,
                 const scene::AirProperties& air);

}  // namespace idiophone::app
