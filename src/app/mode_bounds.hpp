#pragma once
// `idiophone modes --bounds`: two-sided bounds beside the modes.

#include <mpi.h>

#include <nlohmann/json.hpp>

#include "idiophone/app/body_modes.hpp"
#include "idiophone/solids/eigenmodes/frequency_bounds.hpp"

namespace idiophone::app {

/// Bounds for the lowest modes, on all ranks; the others are left out afterwards. Collective; rank 0 computes.
/// @param known   found with the consistent mass: eigenmodes::modes_for_bounds(wanted) modes
/// @param meshes  of the body, on rank 0
[[nodiscard]] eigenmodes::FrequencyBounds take_bounds(BodyModes& known, int wanted, const scene::Solids& solids,
                                                      const std::vector<mesh::Mesh>& meshes, MPI_Comm communicator);

/// What the lower bounds assume, in words.
[[nodiscard]] std::string assumption(const eigenmodes::FrequencyBounds& bounds);

/// The bounds of all modes and what they assume, for files.
[[nodiscard]] nlohmann::json bounds_facts(const eigenmodes::FrequencyBounds& bounds);

}  // namespace idiophone::app
