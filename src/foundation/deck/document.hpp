#pragma once
// YAML text to a tree of values.

#include <optional>
#include <string>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/foundation/deck/node.hpp"

namespace idiophone::deck {

/// Parses one YAML document.
/// @param text    YAML; may use anchors and aliases, not tags
/// @param origin  the place of the text's first character
/// @param path    of the value in the deck, "" for the whole deck
/// @param mistakes  receives syntax errors and duplicate keys
/// @returns the tree; nullopt after a syntax error
/// @throws DeckError where the tree has no end
[[nodiscard]] std::optional<Node> parse_document(const std::string& text, const Location& origin,
                                                 const std::string& path, Mistakes& mistakes);

}  // namespace idiophone::deck
