#pragma once
// Where loads and constraints take hold: nodes found on the whole mesh by rank 0, then known to all ranks.

#include <mpi.h>

#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::motion {

/// Nodes in global numbers with each one's share of the whole, in the order in which the scene names the things they
/// belong to.
struct Attachments {
  /// Those of one body; groups have empty shares.
  struct OfBody {
    std::vector<mesh::Patch> fixed;            ///< [Body::fixed]
    std::vector<mesh::Patch> driven;           ///< [Body::driven]
    std::vector<mesh::Patch> supports;         ///< [Body::supports]
    std::vector<mesh::FractureFace> fracture;  ///< [Mesh::fracture_faces]
  };
  std::vector<mesh::Patch> pulses;  ///< [Solids::pulses]
  std::vector<Vector3>
      pulse_points;  ///< [Solids::pulses] mean point of the patch: the shares times the nodes' positions, m
  std::vector<mesh::Patch> plucks;                 ///< [Solids::plucks]
  std::vector<mesh::Patch> bows;                   ///< [Solids::bows]
  std::vector<std::vector<mesh::Triangle>> winds;  ///< [Solids::winds] surfaces that they push, in their order
  std::vector<std::vector<mesh::Patch>> gauges;    ///< [Solids::gauges][points]
  std::vector<joints::MeshedJoint> joints;         ///< in the order of Solids::joints
  std::vector<OfBody> bodies;                      ///< [Solids::bodies]
};

/// Finds every group and patch of the scene. Call where the meshes are.
/// @throws deck::DeckError for a group that the mesh lacks, a point off the body, a hinge that is not straight, or a
///         joint that joins nothing
[[nodiscard]] Attachments attach(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes);
/// The same where springs, hinges and shanks hold parts of the meshes that are known, such as refined ones.
[[nodiscard]] Attachments attach(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                 const joints::HeldParts& held);

/// Rank 0's attachments, on every rank. Collective.
[[nodiscard]] Attachments broadcast(Attachments attachments, const scene::Solids& solids, MPI_Comm communicator);

/// Sets of nodes that joints and bows couple, for mesh::distribute(): a rank that owns one of a set needs the others.
[[nodiscard]] std::vector<std::vector<Index>> coupled_nodes(const Attachments& attachments);

/// The nodes of a patch that this rank owns, in local numbers, with their shares (empty for groups).
[[nodiscard]] mesh::Patch owned(const mesh::Patch& patch, const mesh::Part& part);

}  // namespace idiophone::motion
