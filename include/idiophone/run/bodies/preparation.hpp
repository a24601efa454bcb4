#pragma once
// From a scene to bodies ready to move: scene -> mesh -> parts -> initial state.

#include <mpi.h>

#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/contact/contact_surfaces.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "idiophone/solids/modal_bodies/modal_models.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/solids/motion/initial_state.hpp"

namespace idiophone::bodies {

/// All that a run, or a check, needs before the first step. The same on all ranks but for `part` and the shapes of
/// modes.
struct Preparation {
  scene::Scene scene;
  mesh::Part part;                            ///< this rank's
  motion::Attachments attachments;            ///< global
  contact::ContactSurfaces contact_surfaces;  ///< what may touch what
  modal_bodies::ModalBases modal_bases;       ///< of the bodies that move by their modes
  motion::InitialState initial_state;         ///< of the whole mesh
  std::vector<mesh::Statistics> statistics;   ///< [bodies]; on rank 0 only
  std::string mesh_hash;                      ///< of all bodies' meshes
  mesh::Offsets offsets;                      ///< first global numbers of each body
  std::vector<double> radii;  ///< [part.surface] surface::equivalent_radii where radiation asks for them
  int steps_per_sample = 0;   ///< m
  int steps_per_read = 0;     ///< k: the surface is read after each k steps

  /// dt = 1/(m rate), s
  [[nodiscard]] double step() const { return 1.0 / (static_cast<double>(steps_per_sample) * scene.audio.rate); }

  /// What makes the models of the bodies; this object has to outlive it.
  [[nodiscard]] motion::ModelMaker models() const { return modal_bodies::modal_models(scene, modal_bases); }
};

/// Reads or makes the meshes of bodies, on rank 0; none elsewhere. Collective.
/// @throws deck::DeckError for a mesh that can't be used, on rank 0, and parallel::RemoteFailure elsewhere
[[nodiscard]] std::vector<mesh::Mesh> read_meshes(const scene::Solids& solids, MPI_Comm communicator);

/// Partitions all bodies, and finds their initial state. Collective.
/// @param scene   the same on all ranks
/// @param whole   meshes of its bodies, on rank 0; those of bodies that can break are divided here
/// @throws deck::DeckError for a wrong deck, on rank 0, and parallel::RemoteFailure elsewhere; std::runtime_error
[[nodiscard]] Preparation prepare(scene::Scene scene, const std::vector<mesh::Mesh>& whole, MPI_Comm communicator);

/// With the meshes that it was made from.
struct PreparedMeshes {
  Preparation ready;
  std::vector<mesh::Mesh> meshes;       ///< on rank 0; without elements where each rank has read its part
  std::vector<mesh::ElementRows> rows;  ///< [bodies] where each rank has read its part: the elements that it read, if
                                        ///< they are kept; otherwise empty
};

/// What is to become of the elements that a rank reads, when it has its part.
enum class ReadRows { drop, keep };

/// The same; reads the meshes. Where they are large mesh files, each rank reads its part (docs/use/meshes.md says
/// which).
[[nodiscard]] PreparedMeshes prepare_with_meshes(scene::Scene scene, MPI_Comm communicator,
                                                 ReadRows rows = ReadRows::drop);

/// The same; drops the meshes.
[[nodiscard]] Preparation prepare(scene::Scene scene, MPI_Comm communicator);

}  // namespace idiophone::bodies
