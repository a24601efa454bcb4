#pragma once
// Sounds as ranks send them to each other.

#include <span>
#include <vector>

#include "idiophone/air/harmonic/body_radiation.hpp"
#include "idiophone/air/harmonic/boundary_elements.hpp"

namespace idiophone::harmonic {

/// Appends all numbers of a sound, one after the other. Its name is left out.
void pack(const RadiatedSound& sound, std::vector<Complex>& packed);

/// The reverse of pack().
/// @return what comes after the sound
[[nodiscard]] std::span<const Complex> unpack(std::span<const Complex> packed, RadiatedSound& sound);

}  // namespace idiophone::harmonic
