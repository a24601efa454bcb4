#pragma once
// A deck with all defaults.

#include <filesystem>
#include <string>
#include <vector>

namespace idiophone::scene {

/// A deck with overrides, defaults and absolute names of files: YAML. It is a deck of the same run. Keys without
/// default, or with one that the program chooses, are omitted.
/// @param overrides  "key.path=value" each
/// @throws deck::DeckError and std::runtime_error as read_deck() does.
[[nodiscard]] std::string resolved_deck(const std::filesystem::path& deck,
                                        const std::vector<std::string>& overrides = {});

}  // namespace idiophone::scene
