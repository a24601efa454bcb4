#pragma once
// The recordings of blows on a body, cut to the part in which the body rings by itself.

#include <span>
#include <vector>

#include "idiophone/study/measured_maps/measured_deck.hpp"

namespace idiophone::measured_maps {

struct Recordings {
  double rate = 0.0;                                       ///< samples per second
  std::vector<std::vector<std::vector<double>>> pressure;  ///< [blows][microphones][samples], all of one length, Pa
  std::vector<double> start;                               ///< [blows] time of the first sample after the blow, s
};

/// @param delays  [microphones] travel time of the sound, s
/// @throws deck::DeckError pointing at `sound` of a blow, std::runtime_error as spectra::read_sound_file()
[[nodiscard]] Recordings read_recordings(const MeasuredBody& body, std::span<const double> delays);

}  // namespace idiophone::measured_maps
