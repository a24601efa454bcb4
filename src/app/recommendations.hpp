#pragma once
// The meshes that `check` recommends.

#include <nlohmann/json_fwd.hpp>

#include "idiophone/mesh/recommendation.hpp"
#include "idiophone/source/preparation.hpp"

namespace idiophone::app {

/// Prints the cheapest mesh of body b, and tet10 for a body that may not be swept.
void print_recommendation(const source::Preparation& ready, std::size_t b, const mesh::Accuracy& wanted);

/// The same as JSON: one entry for hex and one for tet10, where there is one, and the deck's keys that are left out.
[[nodiscard]] nlohmann::json recommendation_facts(const source::Preparation& ready, std::size_t b,
                                                  const mesh::Accuracy& wanted);

}  // namespace idiophone::app
