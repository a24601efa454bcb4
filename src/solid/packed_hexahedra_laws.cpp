// The loops over hexahedra by each law; the other files only know that they exist.

#include "hexahedron_kernels.hpp"
#include "idiophone/solid/elasticity.hpp"
#include "laws.hpp"

namespace idiophone::solid {

using Isotropic = IsotropicElasticity;
using Anisotropic = AnisotropicElasticity;
using Energies = std::span<double>;

template void PackedHexahedra::add_internal_force(const Undamped<Isotropic>&, const NodeState*, NodeForce*) const;
template void PackedHexahedra::add_internal_force(const Undamped<Anisotropic>&, const NodeState*, NodeForce*) const;
template void PackedHexahedra::add_internal_force(const KelvinVoigt<Isotropic>&, const NodeState*, NodeForce*) const;
template void PackedHexahedra::add_internal_force(const KelvinVoigt<Anisotropic>&, const NodeState*, NodeForce*) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Isotropic, true>&, const NodeState*, NodeForce*) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Anisotropic, true>&, const NodeState*,
                                                  NodeForce*) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Isotropic, false>&, const NodeState*, NodeForce*) const;
template void PackedHexahedra::add_internal_force(const Maxwell<Anisotropic, false>&, const NodeState*,
                                                  NodeForce*) const;

template void PackedHexahedra::elastic_energy(const Undamped<Isotropic>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const Undamped<Anisotropic>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const KelvinVoigt<Isotropic>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const KelvinVoigt<Anisotropic>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Isotropic, true>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Anisotropic, true>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Isotropic, false>&, const NodeState*, Energies) const;
template void PackedHexahedra::elastic_energy(const Maxwell<Anisotropic, false>&, const NodeState*, Energies) const;

}  // namespace idiophone::solid
