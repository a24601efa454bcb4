#pragma once
// Listeners of a deck: where they are, how they move, and what they hear with.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/deck/location.hpp"
#include "idiophone/types.hpp"

namespace idiophone::scene {

/// Where something is, and how fast it moves.
struct Place {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 velocity = Vector3::Zero();  ///< m/s
};

/// Where a listener goes: smoothly through points at given times, before the first and after the last of them straight
/// on. Equal points at either end make it stand there.
struct Path {
  /// A point that it goes through.
  struct Point {
    double time = 0.0;                   ///< s
    Vector3 position = Vector3::Zero();  ///< m
  };
  std::vector<Point> points;  ///< at least two, times ascending
  deck::Location where;

  /// Position and velocity at a time (s), both continuous: cubics between the points (Hermite), whose velocity at a
  /// point is that of the parabola through it and its two neighbours. Points of a steady motion give that motion.
  [[nodiscard]] Place at(double time) const;

  /// No speed is above this, m/s.
  [[nodiscard]] double fastest() const;
};

/// A point that hears: one audio channel.
struct Receiver {
  std::string channel;                 ///< e.g. "ears.left"
  Vector3 position = Vector3::Zero();  ///< m; at time 0 where it moves
  Vector3 axis = Vector3::UnitZ();     ///< unit vector: where a directional microphone looks
  double directivity = 0.0;            ///< d of its sensitivity 1 - d + d cos(angle off the axis)
};

/// A head that hears with two ears, by the responses that were measured at them from many directions.
struct Head {
  Vector3 look = -Vector3::UnitZ();  ///< unit vector: where the nose points
  Vector3 up = Vector3::UnitY();     ///< unit vector across `look`: where the top of the head points
  std::filesystem::path responses;   ///< .sofa, of the convention SimpleFreeFieldHRIR
  deck::Location where;              ///< of the file's name, or of the listener
};

/// One or two receivers under one name, written to one WAV file and one dataset of one or two channels.
struct Listener {
  std::string name;
  std::vector<Receiver> receivers;  ///< mono: 1; stereo: left, then right (section 4 of the paper: 20 cm apart);
                                    ///< binaural: left, then right, both at the head's centre
  std::optional<Path> path;         ///< what moves the receivers, whose axes keep their directions
  std::optional<Head> head;         ///< binaural only
  deck::Location where;

  /// Where one of its receivers is at a time (s).
  [[nodiscard]] Place place(const Receiver& receiver, double time) const;
};

}  // namespace idiophone::scene
