#pragma once
// The bodies of decks as proxies on a stage.

#include <memory>
#include <vector>

#include "cast.hpp"

namespace idiophone::timbre {

/// All bodies of all decks, which share a budget.
/// @param all_levels  [decks][bodies]
/// @param shared      budget with sound maps, or null
/// @param sizes       gets those of all levels
[[nodiscard]] std::unique_ptr<voices::ProxyVoices> proxy_voices(const std::vector<scene::Scene>& decks,
                                                                const std::vector<std::vector<ProxyLevels>>& all_levels,
                                                                const voices::Audience& audience,
                                                                const PlaySettings& settings, int rate,
                                                                const std::shared_ptr<voices::SharedBudget>& shared,
                                                                std::vector<LevelSize>& sizes);

}  // namespace idiophone::timbre
