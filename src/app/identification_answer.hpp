#pragma once
// What `idiophone identify` answers, as text and as JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "idiophone/study/fitting/identification.hpp"

namespace idiophone::app {

/// @param body  its name in the deck
void print(const fitting::Identification& found, const std::string& body);

/// The keys are those of docs/use/identify.md.
[[nodiscard]] nlohmann::json identification_facts(const fitting::Identification& found);

}  // namespace idiophone::app
