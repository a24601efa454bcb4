#pragma once
// --set key.path=value: values given on the command line in place of the deck's.

#include <string>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/foundation/deck/node.hpp"

namespace idiophone::deck {

/// Sets one value of the deck, or adds it where the deck has none. The value is YAML; elements of a list go by their
/// index from 0, the index after the last appends. The value null removes a key. Places it gives are in the file "--set
/// <argument>", line 1.
void apply_override(Node& deck, const std::string& argument, Mistakes& mistakes);

}  // namespace idiophone::deck
