// The loops over hexahedra by the laws of prestressed bodies (see packed_hexahedra_laws.cpp).

#include "hexahedron_kernels.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "laws.hpp"

namespace idiophone::solid {

using Isotropic = IsotropicElasticity;
using Anisotropic = AnisotropicElasticity;
using States = std::span<const NodeState>;
using Forces = std::span<NodeForce>;
using Energies = std::span<double>;
template <class Elasticity>
using Advancing = Maxwell<Elasticity, MemoryUse::advance>;
template <class Elasticity>
using Reading = Maxwell<Elasticity, MemoryUse::read>;

template void PackedHexahedra::add_internal_force(const Prestressed<Undamped<Isotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Undamped<Anisotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<KelvinVoigt<Isotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<KelvinVoigt<Anisotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Advancing<Isotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Advancing<Anisotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Reading<Isotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Reading<Anisotropic>>&, PackRange, HeldForces*,
                                                  States, Forces) const;

template void PackedHexahedra::elastic_energy(const Prestressed<Undamped<Isotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Undamped<Anisotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<KelvinVoigt<Isotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<KelvinVoigt<Anisotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Advancing<Isotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Advancing<Anisotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Reading<Isotropic>>&, PackRange, States,
                                              Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Reading<Anisotropic>>&, PackRange, States,
                                              Energies) const;

}  // namespace idiophone::solid
