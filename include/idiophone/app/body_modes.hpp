#pragma once
// The modes of a body, or of bodies that joints tie together, with their meshes; and estimates of what the mesh of a
// body does to them.

#include <mpi.h>

#include <vector>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::app {

struct BodyModes {
  mesh::Offsets offsets;  ///< of the bodies
  mesh::Part part;        ///< this rank's
  eigenmodes::Modes found;
  std::vector<std::vector<double>> shapes;  ///< [modes][3 x nodes], m, in the order of the mesh's nodes; on rank 0
};

/// Collective.
/// @param solids  one body, or bodies that joints tie together
/// @param meshes  of them, on rank 0
/// @throws as eigenmodes::find_modes(); deck::DeckError where the body can't be held as the deck says
[[nodiscard]] BodyModes find_body_modes(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                        const eigenmodes::Options& options, MPI_Comm communicator);

/// Estimated errors of the mesh, [modes] in cents, on all ranks; none where they are not wanted. Collective; rank 0
/// computes.
/// @param wanted  of which modes; a log says which are left out
/// @param meshes  of the body, on rank 0
/// @param shapes  [modes][3 x nodes], on rank 0
/// @param watch   of rank 0; if it ends the work, the modes that are left have no estimate
[[nodiscard]] std::vector<double> estimated_mesh_errors(eigenmodes::Estimates wanted, eigenmodes::MassMatrix mass,
                                                        const scene::Solids& solids,
                                                        const std::vector<mesh::Mesh>& meshes,
                                                        const std::vector<std::vector<double>>& shapes,
                                                        MPI_Comm communicator, const PartWatch& watch = {});

}  // namespace idiophone::app
