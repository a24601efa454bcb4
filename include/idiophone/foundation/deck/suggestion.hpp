#pragma once
// What a misspelt name was meant to be.

#include <string>
#include <string_view>
#include <vector>

namespace idiophone::deck {

/// Letters to insert, delete or exchange to turn one word into the other, whatever their case (Levenshtein distance).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// " (did you mean 'young'?)" with the nearest of the known names; "" where none comes near. Three letters or more that
/// begin a known name mean that name.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& known);

}  // namespace idiophone::deck
