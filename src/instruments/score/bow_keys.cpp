// Bows.

#include "idiophone/scene/bow_keys.hpp"

#include "actions.hpp"
#include "idiophone/scene/ranges.hpp"

namespace idiophone::score {

void read_bow(deck::Section& section, Bow& bow) {
  section.required("at", bow.at, scene::coordinate);
  scene::read_bowing(section, bow, longest_force);
}

}  // namespace idiophone::score
