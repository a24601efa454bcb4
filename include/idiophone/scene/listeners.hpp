#pragma once
// Listeners of a deck: microphones and heads, their positions and motion.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::scene {

/// Position and velocity.
struct Place {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 velocity = Vector3::Zero();  ///< m/s
};

/// The path of a listener through points at given times, with continuous velocity. Before the first and after the last
/// point the velocity is constant; it is zero if the two points at that end are equal.
struct Path {
  /// A point of the path.
  struct Point {
    double time = 0.0;                   ///< s
    Vector3 position = Vector3::Zero();  ///< m
  };
  std::vector<Point> points;  ///< at least two, times ascending
  deck::Location where;

  /// Position and velocity at a time (s), both continuous: cubics between the points (Hermite), whose velocity at a
  /// point is that of the parabola through it and its two neighbours. Points of a steady motion give that motion.
  [[nodiscard]] Place at(double time) const;

  /// An upper bound of the speed, m/s.
  [[nodiscard]] double fastest() const;
};

/// A receiver: one audio channel.
struct Receiver {
  std::string channel;                 ///< e.g. "ears.left"
  Vector3 position = Vector3::Zero();  ///< m; at time 0 if it moves
  Vector3 axis = Vector3::UnitZ();     ///< unit vector: axis of a directional microphone
  double directivity = 0.0;            ///< d of its sensitivity 1 - d + d cos(angle off the axis)
};

/// A head with two ears, given by measured head-related responses.
struct Head {
  Vector3 look = -Vector3::UnitZ();  ///< unit vector: to the front
  Vector3 up = Vector3::UnitY();     ///< unit vector at right angles to `look`: upward
  std::filesystem::path responses;   ///< .sofa, of the convention SimpleFreeFieldHRIR
  deck::Location where;              ///< of the file's name, or of the listener
};

/// One or two receivers under one name, written to one WAV file and one dataset of one or two channels.
struct Listener {
  std::string name;
  std::vector<Receiver> receivers;  ///< mono: 1; stereo: left, then right (section 4 of the paper: 20 cm apart);
                                    ///< binaural: left, then right, both at the head's centre
  std::optional<Path> path;         ///< of the receivers, whose axes keep their directions
  std::optional<Head> head;         ///< binaural only
  std::optional<std::string> attached = {};  ///< the body that carries the receivers and turns their axes
  deck::Location where;

  /// Position and velocity of one of its receivers at a time (s).
  [[nodiscard]] Place place(const Receiver& receiver, double time) const;
};

}  // namespace idiophone::scene
