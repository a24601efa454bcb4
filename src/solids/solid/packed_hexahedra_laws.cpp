// The loops over hexahedra by each law; the other files only know that they exist.

#include "hexahedron_kernels.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "laws.hpp"

namespace idiophone::solid {

using Isotropic = IsotropicElasticity;
using Anisotropic = AnisotropicElasticity;
using States = std::span<const NodeState>;
using Forces = std::span<NodeForce>;
using Energies = std::span<double>;

template void PackedHexahedra::add_internal_force(const Undamped<Isotropic>&, PackRange, HeldForces*, States,
                                                  Forces) const;
template void PackedHexahedra::add_internal_force(const Undamped<Anisotropic>&, PackRange, HeldForces*, States,
                                                  Forces) const;
template void PackedHexahedra::add_internal_force(const KelvinVoigt<Isotropic>&, PackRange, HeldForces*, States,
                                                  Forces) const;
template void PackedHexahedra::add_internal_force(const KelvinVoigt<Anisotropic>&, PackRange, HeldForces*, States,
                                                  Forces) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Isotropic, MemoryUse::advance>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Anisotropic, MemoryUse::advance>&, PackRange,
                                                  HeldForces*, States, Forces) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Isotropic, MemoryUse::read>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Anisotropic, MemoryUse::read>&, PackRange, HeldForces*,
                                                  States, Forces) const;

template void PackedHexahedra::elastic_energy(const Undamped<Isotropic>&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const Undamped<Anisotropic>&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const KelvinVoigt<Isotropic>&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const KelvinVoigt<Anisotropic>&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Isotropic, MemoryUse::advance>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Anisotropic, MemoryUse::advance>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Isotropic, MemoryUse::read>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Anisotropic, MemoryUse::read>&, PackRange, States,
                                              Energies) const;

}  // namespace idiophone::solid
