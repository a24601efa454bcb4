#pragma once
// Which grid a scene needs.

#include <optional>

#include "idiophone/air/waves/enclosing_box.hpp"
#include "idiophone/air/waves/grid.hpp"

namespace idiophone::waves {

/// What is asked for.
struct Wishes {
  Vector3 low = Vector3::Zero(), high = Vector3::Zero();  ///< corners of a box around all surfaces, m
  double cell = 0.004;                                    ///< edge of a cell, m
  double margin = 0.0;                                    ///< free space around that box, m
  double speed = 343.0;                                   ///< of sound, m/s
  int rate = 44100;                                       ///< audio samples per second
  std::optional<double> floor;                            ///< height z of a rigid floor, m
};

struct Plan {
  Grid grid;
  Enclosure enclosure;   ///< around the surfaces, in the open air
  int steps = 1;         ///< in an audio sample
  double courant = 0.0;  ///< c dt/h

  [[nodiscard]] double cells() const;  ///< of the grid
  [[nodiscard]] double bytes() const;  ///< about so much memory on all ranks
  /// The room that surfaces may move in.
  [[nodiscard]] Enclosure reach() const;
  /// Ten cells are a wavelength of it, Hz.
  [[nodiscard]] double highest_frequency(double speed) const { return speed / (10.0 * grid.cell); }
};

/// The smallest number of steps in an audio sample that is stable.
/// @param speed  of sound, m/s
/// @param cell   edge of a cell, m
/// @param rate   audio samples per second
[[nodiscard]] int steps_in_sample(double speed, double cell, int rate);

/// c dt/h with that number of steps; likewise.
[[nodiscard]] double courant_of(double speed, double cell, int rate);

/// @throws std::runtime_error if the grid would have more than 4e9 cells
[[nodiscard]] Plan make_plan(const Wishes& wishes);

}  // namespace idiophone::waves
