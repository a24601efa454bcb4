#pragma once
// How the variables of a sonic scene are read: numbers, keyframes, motion channels and quantities of contacts.

#include <array>
#include <vector>

#include "idiophone/scene/sections.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"

namespace idiophone::timbre {

struct NumberPair {};

/// A list of two numbers.
bool read(const deck::Node& node, deck::Mistakes& mistakes, std::array<double, 2>& pair, const NumberPair& rule);

/// The keys scale, offset, curve and range.
void read_mapping(deck::Section& section, Mapping& mapping);

/// The keys channel, column, interpolation and derivative.
void read_channel(deck::Section& section, MotionVariable& motion);

/// What a parameter may be bound to by name.
struct VariableRules {
  std::vector<NamedVariable> named;
};

/// A constant, {keys}, {event}, {channel}, or the name of a variable.
bool read(const deck::Node& node, deck::Mistakes& mistakes, NamedVariable& named, const VariableRules& rules);

}  // namespace idiophone::timbre
