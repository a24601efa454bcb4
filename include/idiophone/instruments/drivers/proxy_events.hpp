#pragma once
// From the events of a score to what happens to proxies.

#include <cstdint>
#include <optional>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::drivers {

/// The forces of an event; none for a tuning.
/// @param start  audio sample
[[nodiscard]] std::vector<proxies::Force> event_forces(const score::ScoreEvent& event, std::int64_t start,
                                                       std::uint64_t seed, int rate);

/// The tuning of an event; none for a force.
/// @param start  audio sample
[[nodiscard]] std::optional<proxies::Tuning> tuning_of(const score::ScoreEvent& event, std::int64_t start);

/// Adds what a score's event does to a body.
/// @param start  audio sample
/// @throws std::invalid_argument for a body that can't be tuned so
void add_event(const score::ScoreEvent& event, std::int64_t start, std::uint64_t seed, int rate,
               proxies::Engine& engine);

}  // namespace idiophone::drivers
