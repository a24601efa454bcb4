#pragma once
// Scraping and rolling while somebody leads the tool: its speed and its load change as time goes on.

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/foundation/lanes.hpp"
#include "idiophone/instruments/resonators/damped_oscillator.hpp"
#include "idiophone/instruments/resonators/point_forces.hpp"
#include "idiophone/instruments/score/action.hpp"

namespace idiophone::resonators {

/// A tool that goes to and fro between two points. The roughness is a sum of waves with random phases and the spectrum
/// that stroke_force() has; each wave passes with the present speed.
class RunningStroke {
 public:
  static constexpr std::size_t block = 512;  ///< audio samples that are computed at once

  /// @param stroke  speed and load are those at the beginning
  /// @param seed    of roughness
  RunningStroke(const score::Stroke& stroke, std::uint64_t seed, int rate);

  /// Reached at the end of the next block, evenly.
  /// @param speed  m/s, not negative
  /// @param load   N, not negative
  void change(double speed, double load);

  /// The load falls to zero in the next block.
  void end();
  [[nodiscard]] bool is_over() const { return ends_ && now_.load == 0.0; }

  /// The forces of the next block: at the place where it begins, and at that where it ends.
  /// @param start  audio sample of the block
  [[nodiscard]] std::vector<PointForce> next(std::int64_t start);

 private:
  /// A wave of the roughness.
  struct Wave {
    double number;  ///< 2 pi/length, rad/m
    double height;  ///< m
    double phase;   ///< rad
  };
  struct Motion {
    double speed, load;  ///< m/s, N
  };

  /// Forces of the waves, N; none for waves that pass faster than the rate can hold.
  [[nodiscard]] std::vector<Complex> forces_at(const Motion& motion) const;
  /// Adds some waves to the force in the next block. @param number  of the first one
  void add_waves(std::size_t number, const Motion& next, std::span<const Complex> forces, std::vector<double>& sum);
  /// Where the contact is, and the force there for a normal force of 1. Start and curve are left out.
  [[nodiscard]] PointForce at_place() const;

  score::Stroke stroke_;
  int rate_;
  std::vector<Wave> waves_;
  std::vector<Complex> forces_;  // of the waves now, N
  Motion now_{}, wanted_{};
  double way_ = 0.0;  // from `from` to `to` and back again, m
  bool ends_ = false;
};

}  // namespace idiophone::resonators
