#pragma once
// Contacts of bodies with each other and with what stands around them, as scores have them.

#include "actions.hpp"

namespace idiophone::score {

struct ContactRule {
  const BodyNames& bodies;
};

bool read(const deck::Node& node, deck::Mistakes& mistakes, BodyContact& contact, const ContactRule& rule);

}  // namespace idiophone::score
