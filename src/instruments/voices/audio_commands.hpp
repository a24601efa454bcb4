#pragma once
// What the control thread sends to the audio thread. The audio thread sends it back when it is done, because it must
// not free memory.

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "idiophone/instruments/resonators/bodies_in_contact.hpp"
#include "idiophone/instruments/resonators/force.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::voices {

inline constexpr std::size_t most_receivers = 4;

/// A force at one place.
struct ForceCommand {
  std::int64_t start = 0;                                ///< audio sample; the present one if it is over
  resonators::ForceCurve force;                          ///< with its rise
  double strength = 0.0;                                 ///< impulse per mass of the body, N s/kg
  std::int64_t acts_for = 0;                             ///< audio samples; then only the rise is left
  std::vector<resonators::ModeGroup> by_mean, by_slope;  ///< [groups] as in Drive
  std::int64_t sent = 0;                                 ///< ns of the steady clock; 0: not measured
};

/// A contact that feels the body.
struct TouchCommand {
  std::int64_t start = 0;   ///< audio sample; the present one if it is over
  std::int64_t number = 0;  ///< of this body, from 0 on
  double strength = 0.0;    ///< as in ForceCommand, of a second at most
  std::int64_t length = 0;  ///< audio samples until it ends by itself
  std::int64_t rest = 0;    ///< audio samples from its end until nothing is left of its force's rise
  std::unique_ptr<resonators::Contact> contact;
  resonators::ContactPoint point;
};

/// A player leads a contact.
struct LeadCommand {
  std::int64_t start = 0;   ///< audio sample; the present one if it is over
  std::int64_t number = 0;  ///< of the TouchCommand
  std::int64_t length = 0;  ///< audio samples, until the motion is reached
  resonators::ContactMotion motion;
  bool ends = false;  ///< it ends then
};

/// Where the listener is, as seen from a body.
struct ListenerFromBody {
  double distance = 1.0;   ///< of the middle of its receivers, m
  double attention = 1.0;  ///< MapDetail::behind if it looks away from the body, else 1
};

/// What receivers hear of a body.
struct Reception {
  std::vector<resonators::ModeGroup> gains;    ///< [receivers x groups] pressure for z = 1, Pa
  std::array<double, most_receivers> delay{};  ///< [receivers] audio samples
  ListenerFromBody listener{};
  std::vector<double> head;  ///< [2 x taps] responses of the ears to the only receiver; or none
};

/// The reception changes linearly to another one.
struct ReceptionChange {
  std::int64_t start = 0;   ///< audio sample; later if the present one or another change is not over then
  std::int64_t length = 1;  ///< audio samples
  Reception reception;
  bool leaves = false;  ///< for good: no other change follows
};

/// The modes get other frequencies and decay rates. What sounds goes on.
struct Retuning {
  std::int64_t start = 0;                    ///< audio sample; the present one if it is over
  std::vector<resonators::ModeGroup> turns;  ///< [groups]
  double size = 1.0;                         ///< of the body over that of its map
  /// Where contacts act, by the numbers of their commands.
  std::vector<std::pair<std::int64_t, resonators::ContactPoint>> points;
};

using Command = std::variant<std::unique_ptr<ForceCommand>, std::unique_ptr<TouchCommand>, std::unique_ptr<LeadCommand>,
                             std::unique_ptr<ReceptionChange>, std::unique_ptr<Retuning>>;

}  // namespace idiophone::voices
