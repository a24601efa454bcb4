#pragma once
// What all kinds of packed elements can do.

#include <concepts>
#include <cstddef>
#include <span>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/pack_division.hpp"
#include "idiophone/solids/solid/pack_layout.hpp"

namespace idiophone::solid {

/// Stands for any law of src/solids/solid/laws.hpp.
struct AnyLaw;

/// One body's elements on this rank in packs (AoSoA). They are constructed from a mesh::BodyPart, whose nodes
/// are local numbers, and the reference positions X of the [local nodes], m; the constructor throws std::runtime_error
/// naming the element whose Jacobian is not positive at a quadrature point.
///
/// - add_internal_force(law, state, force) adds f_a = -sum_q w_q P grad N_a to the nodes' forces, N, element by element
///   in ascending order; state and force are [local nodes].
/// - add_internal_force(law, range, held, state, force) does so for some of the packs; `held` takes forces that have to
///   wait for packs of another call (pack_division.hpp).
/// - add_mass(density, range, mass) adds the lumped mass of each element of some packs to its nodes: density in kg/m3,
///   mass [local nodes] in kg.
/// - elastic_energy(law, range, state, energy) finds the stored energy of each element of some packs, J, [elements].
/// - element_count() is the number of elements, layout() says which of them are in which pack, and points() is the
///   number of quadrature points of an element.
/// - bytes() is the memory of all tables.
template <class Packs>
concept ElementPacks = requires(const Packs& packs, const AnyLaw& law, std::span<const NodeState> state,
                                std::span<NodeForce> force, HeldForces& held, std::span<double> values) {
  packs.add_internal_force(law, state, force);
  packs.add_internal_force(law, PackRange{}, &held, state, force);
  packs.add_mass(1.0, PackRange{}, values);
  packs.elastic_energy(law, PackRange{}, state, values);
  { packs.element_count() } -> std::same_as<Index>;
  { packs.layout() } -> std::same_as<const PackLayout&>;
  { packs.points() } -> std::same_as<std::size_t>;
  { packs.bytes() } -> std::same_as<std::size_t>;
};

}  // namespace idiophone::solid
