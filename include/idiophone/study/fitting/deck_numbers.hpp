#pragma once
// Numbers in the text of a deck, by their keys: reads them, and writes others in their places.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace idiophone::fitting {

/// The number that a deck has at a key, overrides included.
/// @param key  "bodies.bar.parameters.depth"
/// @throws std::runtime_error if there is no number, or the file can't be read; deck::DeckError for a file that is no
/// deck
[[nodiscard]] double number_at(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                               const std::string& key);

/// The deck's text with other numbers at some keys; all else stays as it is, comments included.
/// @throws std::runtime_error and deck::DeckError as number_at() does
[[nodiscard]] std::string with_numbers(const std::filesystem::path& deck,
                                       const std::vector<std::pair<std::string, double>>& numbers);

}  // namespace idiophone::fitting
