#pragma once
// From a scene to bodies ready to move: scene -> mesh -> parts -> outset.

#include <mpi.h>

#include <string>
#include <vector>

#include "idiophone/contact/partners.hpp"
#include "idiophone/mesh/part.hpp"
#include "idiophone/mesh/statistics.hpp"
#include "idiophone/motion/attachments.hpp"
#include "idiophone/motion/outset.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// All that a run, or a check, needs before the first step. The same on all ranks but for `part`.
struct Preparation {
  scene::Scene scene;
  mesh::Part part;                           ///< this rank's
  motion::Attachments attachments;           ///< global
  contact::Partners partners;                ///< what may touch what
  motion::Outset outset;                     ///< of the whole mesh
  std::vector<mesh::Statistics> statistics;  ///< [bodies]; on rank 0 only
  std::string mesh_hash;                     ///< of all bodies' meshes
  mesh::Offsets offsets;                     ///< first global numbers of each body
  std::vector<double> radii;                 ///< [part.surface] surface::equivalent_radii where radiation asks for them
  int steps_per_sample = 0;                  ///< m
  int steps_per_read = 0;                    ///< k: the surface is read after each k steps

  /// dt = 1/(m rate), s
  [[nodiscard]] double step() const { return 1.0 / (static_cast<double>(steps_per_sample) * scene.audio.rate); }
};

/// Reads and validates a deck on all ranks. Collective.
/// @throws scene::DeckError for a wrong deck, on rank 0, and mesh::RemoteFailure elsewhere
[[nodiscard]] scene::Scene read_scene(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                                      MPI_Comm communicator);

/// Reads, validates, meshes and parts everything. Collective.
/// @throws scene::DeckError for a wrong deck, on rank 0, and mesh::RemoteFailure elsewhere; std::runtime_error
[[nodiscard]] Preparation prepare(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                                  MPI_Comm communicator);

}  // namespace idiophone::app
