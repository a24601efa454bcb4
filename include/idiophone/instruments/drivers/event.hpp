#pragma once
// What drivers ask for: something is done to a body, or the listener goes somewhere.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "idiophone/instruments/resonators/point_forces.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::drivers {

/// How strong an excitation is, for sounds that are no bodies.
struct Strength {
  double force = 0.0;    ///< largest, N
  double impulse = 0.0;  ///< integral of the force over time, N s
  double speed = 0.0;    ///< of the hammer, or of the contact along the surface, m/s; 0 if it is not known
};

/// Forces on a body: a blow, a stroke, or a piece of a contact that lasts.
struct Excitation {
  std::vector<resonators::PointForce> forces{};  ///< starts in audio samples; at least one
  Strength strength{};                           ///< of all its pieces together
  bool begins = true;                            ///< false: a piece that goes on with the one before
  std::optional<Vector3> place = {};             ///< of all forces together, m; that of the first one if empty
};

/// What feels the vibration of a body begins to touch it.
struct Touching {
  std::int64_t number = 0;  ///< by which a player leads it
  std::variant<score::Bow, score::MalletBlow> contact{};
};

/// A player leads a bow: its speed and its load change evenly within TouchLead::length audio samples.
struct TouchLead {
  static constexpr std::int64_t length = 512;

  std::int64_t number = 0;  ///< of the Touching; nothing happens if it is over
  double speed = 0.0;       ///< m/s
  double load = 0.0;        ///< N
  bool ends = false;        ///< it is over then
};

/// The listener goes there.
struct ListenerMove {
  Vector3 position = Vector3::Zero();  ///< m
};

struct Event {
  std::int64_t start = 0;  ///< audio sample; at once if it is over
  std::size_t body = 0;    ///< of the stage; none for a ListenerMove
  std::variant<Excitation, Touching, TouchLead, score::Tuning, score::Detail, ListenerMove> action{};
  std::int64_t sent = 0;  ///< ns of the steady clock when a player asked for it; 0: it was known before
};

/// What an event of a score does.
/// @param start  audio sample
/// @param seed   of roughness
[[nodiscard]] Event event_of(const score::ScoreEvent& event, std::int64_t start, std::uint64_t seed, int rate);

}  // namespace idiophone::drivers
