#pragma once
// From what a score says to the commands of the audio thread.

#include <cstdint>
#include <span>
#include <vector>

#include "audio_commands.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "instrument.hpp"

namespace idiophone::voices {

/// The forces of an event, which is no tuning.
/// @param instrument  that the event happens to
/// @param start       audio sample
/// @param seed        of roughness
[[nodiscard]] std::vector<Command> commands_of(const score::ScoreEvent& event, const Instrument& instrument,
                                               std::int64_t start, std::uint64_t seed);

}  // namespace idiophone::voices
