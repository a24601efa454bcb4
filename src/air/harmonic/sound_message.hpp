#pragma once
// Sounds as ranks send them to each other.

#include <span>
#include <vector>

#include "idiophone/air/harmonic/body_radiation.hpp"
#include "idiophone/air/harmonic/boundary_elements.hpp"

namespace idiophone::harmonic {

/// Appends all complex numbers of a sound, and its facts, one after the other. Name and frequency are left out.
void pack(const RadiatedSound& sound, std::vector<Complex>& packed);

/// The reverse of pack().
/// @param facts  how many numbers the fields of the sound have
/// @return what comes after the sound
[[nodiscard]] std::span<const Complex> unpack(std::span<const Complex> packed, const Radiation& facts,
                                              RadiatedSound& sound);

}  // namespace idiophone::harmonic
