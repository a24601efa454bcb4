#pragma once
// Estimates of what the mesh does to the frequencies of some of many modes.

#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// Estimates as mesh_errors() for modes that are spread evenly from the lowest to the highest: as many as take about
/// ten seconds of one core, and at least four unless one alone takes longer.
/// @param solids, meshes, mass, shapes  as mesh_errors() takes them
/// @return [modes] cents by which each frequency is too high; NaN of modes without an estimate
[[nodiscard]] std::vector<double> spread_mesh_errors(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                                     MassMatrix mass, std::span<const std::vector<double>> shapes);

}  // namespace idiophone::eigenmodes
