#pragma once
// How a body stretches where its vibrations are large.

#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "operators.hpp"
#include "shifted_stiffness.hpp"

namespace idiophone::eigenmodes {

/// What is wrong with a prestress beside large amplitudes.
constexpr const char* deforms =
    "deforms the body, and large_amplitudes are possible about the undeformed shape only: give a stress that pulls on "
    "held faces only, or leave out large_amplitudes";

/// Finds the strains that stretching consists of by a range finder (Halko, Martinsson and Tropp, SIAM Review 53, 2011):
/// random vibrations, with the same energy in all modes on average, give strains, until new ones hold nothing new. The
/// random numbers are the same in each call. Runs on one rank.
/// @param basis      modes, masses and whether the body is free
/// @param stiffness  of the body, with a shift far below the lowest mode where it can move rigidly, and without one
///                   where it cannot
/// @param tolerance  share of the energy of stretching that may be left out
/// @throws std::runtime_error where a prestress deforms the body
[[nodiscard]] modal_bodies::Stretching find_stretching(const Operators& operators, const mesh::Part& part,
                                                       const modal_bodies::ModalBasis& basis,
                                                       const ShiftedStiffness& stiffness, double tolerance);

}  // namespace idiophone::eigenmodes
