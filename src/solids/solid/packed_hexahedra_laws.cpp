// The loops over hexahedra by each law; the other files only know that they exist.

#include "hexahedron_kernels.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "laws.hpp"

namespace idiophone::solid {

using Isotropic = IsotropicElasticity;
using Anisotropic = AnisotropicElasticity;
using Energies = std::span<double>;

template void PackedHexahedra::add_internal_force(const Undamped<Isotropic>&, std::span<const NodeState>,
                                                  std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const Undamped<Anisotropic>&, std::span<const NodeState>,
                                                  std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const KelvinVoigt<Isotropic>&, std::span<const NodeState>,
                                                  std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const KelvinVoigt<Anisotropic>&, std::span<const NodeState>,
                                                  std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Isotropic, MemoryUse::advance>&,
                                                  std::span<const NodeState>, std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Anisotropic, MemoryUse::advance>&,
                                                  std::span<const NodeState>, std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Isotropic, MemoryUse::read>&,
                                                  std::span<const NodeState>, std::span<NodeForce>) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Anisotropic, MemoryUse::read>&,
                                                  std::span<const NodeState>, std::span<NodeForce>) const;

template void PackedHexahedra::elastic_energy(const Undamped<Isotropic>&, std::span<const NodeState>, Energies) const;
template void PackedHexahedra::elastic_energy(const Undamped<Anisotropic>&, std::span<const NodeState>, Energies) const;
template void PackedHexahedra::elastic_energy(const KelvinVoigt<Isotropic>&, std::span<const NodeState>,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const KelvinVoigt<Anisotropic>&, std::span<const NodeState>,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Isotropic, MemoryUse::advance>&, std::span<const NodeState>,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Anisotropic, MemoryUse::advance>&,
                                              std::span<const NodeState>, Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Isotropic, MemoryUse::read>&, std::span<const NodeState>,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Anisotropic, MemoryUse::read>&, std::span<const NodeState>,
                                              Energies) const;

}  // namespace idiophone::solid
