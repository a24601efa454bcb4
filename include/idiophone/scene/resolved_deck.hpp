#pragma once
// A deck that says everything.

#include <filesystem>
#include <string>
#include <vector>

namespace idiophone::scene {

/// A deck with the overrides in their places, the defaults of the keys that it leaves out, and absolute names of files:
/// YAML. It is itself a deck, and gives the same run. Keys whose default is nothing, or chosen by the program, are left
/// out.
/// @param overrides  "key.path=value" each
/// @throws deck::DeckError and std::runtime_error as read_deck() does.
[[nodiscard]] std::string resolved_deck(const std::filesystem::path& deck,
                                        const std::vector<std::string>& overrides = {});

}  // namespace idiophone::scene
