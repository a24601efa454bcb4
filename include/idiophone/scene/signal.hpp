#pragma once
// Time functions of loads and driven groups.

#include <array>
#include <vector>

namespace idiophone::scene {

/// A function of time without unit: zero before `start`, then one of the shapes.
struct Signal {
  enum class Shape {
    half_sine,  ///< sin(pi t/duration) until `duration`, then zero
    constant,   ///< one until `duration`
    sine,       ///< sin(2 pi frequency t) until `duration`
    table       ///< linear between the rows of `table`, zero outside them
  };
  Shape shape = Shape::half_sine;
  double start = 0.0;                        ///< s
  double duration = 0.0;                     ///< s; infinity for no end
  double frequency = 0.0;                    ///< Hz, sine only
  std::vector<std::array<double, 2>> table;  ///< rows of (time after start in s, value), times ascending

  /// Value at `time` (s).
  [[nodiscard]] double at(double time) const;

  /// Time from which on it is zero, s; infinity for no end.
  [[nodiscard]] double end() const;
};

}  // namespace idiophone::scene
