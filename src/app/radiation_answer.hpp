#pragma once
// What `idiophone radiate` answers.

#include <nlohmann/json.hpp>

#include "idiophone/air/harmonic/body_radiation.hpp"

namespace idiophone::app {

void print_radiation(const harmonic::Radiation& result);

/// The same for scripts, with the pressures at the listeners.
[[nodiscard]] nlohmann::json radiation_facts(const harmonic::Radiation& result);

}  // namespace idiophone::app
