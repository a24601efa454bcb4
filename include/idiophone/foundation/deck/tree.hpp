#pragma once
// From a file to the tree of a deck, and from the tree to a file.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/foundation/deck/node.hpp"

namespace idiophone::deck {

/// The text of a file. @throws std::runtime_error with the system's reason when it can't be read
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// The tree of a deck with the --set arguments in their places: a map.
/// @param file  that mistakes are said to be in
/// @throws DeckError where the text is no map of keys
[[nodiscard]] Node read_tree(const std::string& text, const std::string& file,
                             const std::vector<std::string>& overrides, Mistakes& mistakes);

/// Whether a deck has a key at its top.
/// @throws as read_text() and read_tree()
[[nodiscard]] bool has_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::string& key);

/// The resolved deck, YAML: what the tree says, the defaults that its readers noted, and files by their absolute paths.
/// @param tree  that was read without mistakes
[[nodiscard]] std::string resolved(const Node& tree);

}  // namespace idiophone::deck
