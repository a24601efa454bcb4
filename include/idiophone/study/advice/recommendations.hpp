#pragma once
// The meshes that `check` recommends.

#include <nlohmann/json_fwd.hpp>

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/accuracy/recommendation.hpp"

namespace idiophone::advice {

/// Prints the cheapest mesh of body b, if there are rules for it, and tet10 for a body that may not be swept.
void print_recommendation(const bodies::Preparation& ready, std::size_t b, const accuracy::Accuracy& wanted);

/// The same as JSON: one entry for hex and one for tet10, where there is one, and the deck's keys that are left out.
[[nodiscard]] nlohmann::json recommendation_facts(const bodies::Preparation& ready, std::size_t b,
                                                  const accuracy::Accuracy& wanted);

}  // namespace idiophone::advice
