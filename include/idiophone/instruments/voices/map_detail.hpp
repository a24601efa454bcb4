#pragma once
// How much of sound maps is heard when the processor can't compute all of it.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/voices/shared_budget.hpp"

namespace idiophone::voices {

/// What sound maps may cost, and what decides which of their modes are heard.
struct MapDetail {
  double budget = std::numeric_limits<double>::infinity();   ///< processor time per time of sound
  double speed = usual_speed;                                ///< of the machine, as ProxyHearing::speed
  proxies::Priority priority = proxies::Priority::distance;  ///< of the bodies
  double behind = 1.0;                                       ///< as EngineOptions::behind
  std::shared_ptr<SharedBudget> shared{};                    ///< with proxies, if there are any
  std::size_t most_commands = 1024;  ///< to a body that can be on their way, waiting or acting at once
  bool masking = true;               ///< modes that others hide are left out first; false: the weakest modes of a body
};

/// What was chosen for an interval of MapChoice::interval audio samples.
struct MapChoice {
  static constexpr std::int64_t interval = 1024;

  std::int64_t sample = 0;   ///< at which the interval begins
  std::size_t sounding = 0;  ///< bodies that sound or ring on unheard
  std::size_t silent = 0;    ///< those of which nothing is heard or fades
  std::size_t modes = 0;     ///< of the sounding bodies
  std::size_t heard = 0;     ///< of these modes
  double cost = 0.0;         ///< of what is heard or fades, processor time per time of sound
  double power = 0.0;        ///< of all modes where the listener is, mean square of the pressure, Pa^2
  double left_out = 0.0;     ///< share of the power that the other modes have
};

}  // namespace idiophone::voices
