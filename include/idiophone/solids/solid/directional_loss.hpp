#pragma once
// Loss factors by direction (scene::DirectionalLoss). With one loss factor for all directions, the stiffness is C M,
// with the complex modulus M of its relaxation. Here M acts on a part C_r of C: C + (M - 1) C_r. M is that of the
// largest loss factor h.
//
// The imaginary part of the compliance S = 1/C shall have the terms h_i S_ii, with the loss factors h_i of the moduli.
// D S D h has them, where the diagonal matrix D has the roots of h_i/h; it never creates energy, whatever the h_i are.
// To first order in them this is C_r = C D S D C.

#include "idiophone/solids/solid/elasticity.hpp"
#include "idiophone/solids/solid/oriented_material.hpp"

namespace idiophone::solid {

/// C_r, the part of the elasticity that relaxes; all of it if the material has no loss factors by direction.
[[nodiscard]] Elasticity relaxing_elasticity(const OrientedMaterial& oriented);

/// C + (M - 1) C_r
/// @param modulus  M, real; above what Relaxation::long_term is
/// @throws deck::DeckError where this is not positive definite
[[nodiscard]] Elasticity elasticity_at(const OrientedMaterial& oriented, double modulus);

/// The map of a strain to the strain whose stress by C is that of the first by C_r. Its `stress` is a strain, without
/// unit. The material has loss factors by direction.
[[nodiscard]] AnisotropicElasticity relaxing_strain(const OrientedMaterial& oriented);

/// The largest share of C_r in C that any strain meets, without unit.
[[nodiscard]] double largest_relaxing_share(const OrientedMaterial& oriented);

}  // namespace idiophone::solid
