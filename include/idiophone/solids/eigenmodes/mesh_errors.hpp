#pragma once
// An estimate of what the mesh does to the frequencies of modes, from the mesh itself.

#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// Estimates the error of each frequency (docs/method/modes.md, The error of the mesh): the mode goes on on the refined
/// mesh (mesh::refined()), where a few steps of a preconditioned gradient method lower its eigenvalue, and what the
/// refined mesh still errs is extrapolated. Both meshes have one shape: how far it is from that of the true body is not
/// estimated. Runs on one rank.
/// @param solids  of one body, or of bodies that joints tie together: see why_no_estimates()
/// @param meshes  of the bodies
/// @param mass    that the modes were found with
/// @param shapes  [modes][3 x nodes of all bodies] of the modes, ascending by frequency
/// @param watch   if it ends the work, there are fewer estimates
/// @return [modes] cents by which each frequency is too high
/// @throws deck::DeckError as motion::attach() and joints::refined(), solid::InvertedElement where a curved element
/// can't be divided,
///         std::runtime_error where PETSc can't
[[nodiscard]] std::vector<double> mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                              MassMatrix mass, std::span<const std::vector<double>> shapes,
                                              const PartWatch& watch = {});

/// Of which modes the error is estimated.
enum class Estimates {
  none,
  quick,  ///< of the lowest ones, as many as take about ten seconds of one core
  all
};

/// Estimates for the modes that are wanted.
struct MeshErrors {
  std::vector<double> cents;  ///< [modes] NaN of modes without an estimate; empty if all would take too long
  std::string why_none;       ///< why no mode has the estimate that is wanted, and what to do; empty if one has
};

/// The same for some of the modes. None has an estimate where a curved element can't be divided or the refined bodies
/// are no assembly at rest (deck::DeckError).
/// @param watch  if it ends the work, the modes that are left have no estimate
[[nodiscard]] MeshErrors mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                     MassMatrix mass, std::span<const std::vector<double>> shapes, Estimates wanted,
                                     const PartWatch& watch = {});

/// Why mesh_errors() does not know the joints or elements of these bodies, and what to do; empty where it does. All
/// elements have to be of one kind, and no joint a bolt without a shank: the area under its washer changes with the
/// mesh.
[[nodiscard]] std::string why_no_estimates(const scene::Solids& solids);

/// What mesh_errors() leaves out, as a sentence for the user; empty if it leaves out nothing.
/// @param errors    its result
/// @param modes     how many there are
/// @param why_none  likewise; empty where it is not known
[[nodiscard]] std::string left_out(std::span<const double> errors, std::size_t modes, Estimates wanted,
                                   const std::string& why_none = {});

}  // namespace idiophone::eigenmodes
