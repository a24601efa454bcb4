#pragma once
// The bodies that the audio thread plays.

#include <memory>
#include <vector>

#include "mode_choice.hpp"

namespace idiophone::voices {

class ContactGroup;

/// The control thread makes a new one when bodies join or leave, and hands it over as a whole.
struct Lineup {
  std::vector<MapBody*> by_number;       ///< null: no body has this number
  std::vector<MapBody*> bodies;          ///< in the order of their numbers
  std::vector<ContactGroup*> groups;     ///< of all bodies
  std::unique_ptr<ModeChoice> choice;    ///< among their modes
  std::vector<const MapBody*> sounding;  ///< in the present piece; has room for all
};

}  // namespace idiophone::voices
