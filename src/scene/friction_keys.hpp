#pragma once
// The keys of friction with memory, which bows and contacts have.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/foundation/friction/law.hpp"

namespace idiophone::scene {

/// Reads the keys of the law from a section that may have others.
void read_law(deck::Section& section, friction::Law& law);

}  // namespace idiophone::scene
