#pragma once
// Point masses that stand for a continuous body.

#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Volume, m3; negative if the last corner is on the other side of the first three.
[[nodiscard]] double signed_volume(const std::vector<Vector3>& nodes, const std::array<Index, 4>& tetrahedron);

/// Volumes, [tetrahedra] m3. @throws std::invalid_argument for a flat tetrahedron or a node number out of range
[[nodiscard]] std::vector<double> volumes(const TetrahedralMesh& mesh);

/// Of point masses.
[[nodiscard]] Inertia inertia_of(std::span<const Vector3> positions, std::span<const double> masses);

/// Of tetrahedra filled with mass.
[[nodiscard]] Inertia inertia_of(const TetrahedralMesh& mesh, std::span<const double> volumes, double density);

/// Masses at the nodes, as Lattice says, [nodes] kg.
[[nodiscard]] std::vector<double> point_masses(const TetrahedralMesh& mesh, std::span<const double> volumes,
                                               double density, const Inertia& body);

}  // namespace idiophone::proxies
