// The loops over hexahedra by the laws of loss factors by direction (see packed_hexahedra_laws.cpp).

#include "hexahedron_kernels.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "laws.hpp"

namespace idiophone::solid {

using States = std::span<const NodeState>;
using Forces = std::span<NodeForce>;
using Energies = std::span<double>;
using Advancing = DirectionalMaxwell<MemoryUse::advance>;
using Reading = DirectionalMaxwell<MemoryUse::read>;

template void PackedHexahedra::add_internal_force(const Advancing&, PackRange, HeldForces*, States, Forces) const;
template void PackedHexahedra::add_internal_force(const Reading&, PackRange, HeldForces*, States, Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Advancing>&, PackRange, HeldForces*, States,
                                                  Forces) const;
template void PackedHexahedra::add_internal_force(const Prestressed<Reading>&, PackRange, HeldForces*, States,
                                                  Forces) const;

template void PackedHexahedra::elastic_energy(const Advancing&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const Reading&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Advancing>&, PackRange, States, Energies) const;
template void PackedHexahedra::elastic_energy(const Prestressed<Reading>&, PackRange, States, Energies) const;

}  // namespace idiophone::solid
