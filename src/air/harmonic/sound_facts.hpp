#pragma once
// The numbers that describe a sound, as files have them and as ranks send them to each other.

#include <array>

#include "idiophone/air/harmonic/body_radiation.hpp"

namespace idiophone::harmonic {

struct SoundFact {
  const char* path;  ///< of the dataset, [sounds]
  const char* unit;
  double RadiatedSound::*value;
};

inline constexpr std::array sound_facts = {
    SoundFact{"/sounds/frequency", "Hz", &RadiatedSound::frequency},
    SoundFact{"/sounds/mean_square_velocity", "m2/s2", &RadiatedSound::mean_square_velocity},
    SoundFact{"/sounds/power", "W", &RadiatedSound::power},
    SoundFact{"/sounds/level_error", "dB", &RadiatedSound::level_error},
    SoundFact{"/sounds/efficiency", "1", &RadiatedSound::efficiency},
    SoundFact{"/sounds/loss_factor", "1", &RadiatedSound::loss_factor},
    SoundFact{"/sounds/directivity_index", "dB", &RadiatedSound::directivity_index},
    SoundFact{"/sounds/kirchhoff_error", "dB", &RadiatedSound::kirchhoff_error},
    SoundFact{"/sounds/kirchhoff_worst", "dB", &RadiatedSound::kirchhoff_worst},
    SoundFact{"/sounds/rayleigh_error", "dB", &RadiatedSound::rayleigh_error},
    SoundFact{"/sounds/rayleigh_worst", "dB", &RadiatedSound::rayleigh_worst},
};

/// Only where the model `waves` was compared.
inline constexpr std::array waves_facts = {
    SoundFact{"/sounds/waves_error", "dB", &RadiatedSound::waves_error},
    SoundFact{"/sounds/waves_worst", "dB", &RadiatedSound::waves_worst},
};

}  // namespace idiophone::harmonic
