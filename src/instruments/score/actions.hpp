#pragma once
// Readers of what is done to bodies. Each reads the keys of one kind of event from its section.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::score {

inline constexpr double longest_force = 60.0;  ///< s, of a stroke, a force or a bow
inline constexpr deck::Range hammer_mass{.at_least = 1e-9, .at_most = 1e6, .unit = "kg"};
inline constexpr deck::Range contact_loss{.at_least = 0.0, .at_most = 1e3, .unit = "s/m"};

/// With their numbers.
using BodyNames = deck::Choices<std::size_t>;

/// The key body, which can be left out if there is one body.
void read_body(deck::Section& section, std::size_t& body, const BodyNames& bodies);

/// When events happen: at a time that they have, or at once, because somebody far away may ask for it.
enum class When { by_time, at_once };

void read_hammer_blow(deck::Section& section, HammerBlow& blow);
void read_mallet_blow(deck::Section& section, MalletBlow& mallet);
void read_applied_force(deck::Section& section, AppliedForce& applied, const deck::Folder& folder, When when);
void read_stroke(deck::Section& section, Stroke& stroke);
/// Without its duration.
void read_bow(deck::Section& section, Bow& bow);
void read_tuning(deck::Section& section, Tuning& tuning);
void read_detail(deck::Section& section, Detail& detail);

}  // namespace idiophone::score
