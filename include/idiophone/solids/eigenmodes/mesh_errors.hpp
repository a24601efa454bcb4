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
/// @param solids  of one body, or of bodies that joints tie together: see can_estimate()
/// @param meshes  of the bodies
/// @param mass    that the modes were found with
/// @param shapes  [modes][3 x nodes of all bodies] of the modes, ascending by frequency
/// @param watch   if it ends the work, there are fewer estimates
/// @return [modes] cents by which each frequency is too high
/// @throws deck::DeckError as motion::attach(), solid::InvertedElement where a curved element can't be divided,
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

/// The same for some of the modes.
/// @param watch  if it ends the work, the modes that are left have no estimate
/// @return [modes] cents, NaN of modes without an estimate, and of all where a curved element can't be divided or the
///         refined bodies are no assembly at rest (deck::DeckError); empty if all would take too long
[[nodiscard]] std::vector<double> mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                              MassMatrix mass, std::span<const std::vector<double>> shapes,
                                              Estimates wanted, const PartWatch& watch = {});

/// Whether mesh_errors() knows the joints and elements of bodies: the joints are glue, and all elements of one kind.
/// The area under the washer of a bolt changes with the mesh.
[[nodiscard]] bool can_estimate(const scene::Solids& solids);

/// What mesh_errors() leaves out, as a sentence for the user; empty if it leaves out nothing.
/// @param errors  its result
/// @param modes   how many there are
[[nodiscard]] std::string left_out(std::span<const double> errors, std::size_t modes, Estimates wanted);

}  // namespace idiophone::eigenmodes
