#pragma once
// The sound power that a force on a body makes, over its frequency.

#include <span>
#include <vector>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// Mean power of the sound while a sinusoidal force with an amplitude of 1 N acts: the sum of all modes in all
/// directions of the far field, with their interference, as play has it (docs/method/sound_map.md, Slow forces).
/// @param participation  of the force (participation()), [modes] 1/sqrt(kg)
/// @param frequencies    above 0 Hz
/// @return [frequencies] W
[[nodiscard]] std::vector<double> radiated_power(const SoundMap& map, std::span<const double> participation,
                                                 std::span<const double> frequencies);

/// Frequencies that show every peak: those of the modes, and 48 in an octave from half the lowest to the highest. Hz,
/// ascending.
[[nodiscard]] std::vector<double> frequencies_with_peaks(const SoundMap& map);

}  // namespace idiophone::sound_maps
