#pragma once
// What taps tell about a body that is tuned: which line is which mode, the constants of its material, and how deep the
// cuts really are.

#include <optional>
#include <string>
#include <vector>

#include "idiophone/scene/material.hpp"
#include "idiophone/study/bench/tap.hpp"
#include "idiophone/study/bench/workpiece.hpp"

namespace idiophone::bench {

/// What is known before any tap. Standard deviations.
struct Beliefs {
  double own = 20.0;          ///< cents of each mode beside what the unknowns explain
  double depth_error = 1e-4;  ///< m, of each cut, and of the thickness of the body
  double slope_error = 0.1;   ///< of what cuts do, over what the model says
};

/// A number that taps tell.
struct Estimate {
  std::string name;        ///< of a constant; empty of a cut
  double expected = 0.0;   ///< above the deck's or the asked one: of ln of a modulus, of a ratio, or m
  double deviation = 0.0;  ///< standard deviation
};

/// Another way to take the lines of the last tap, or a line far from where its mode was expected.
struct Doubt {
  std::size_t mode = 0;              ///< of the uncut body, from 0 on, that is tuned
  double line = 0.0;                 ///< Hz, of the line that may be its own
  std::optional<double> other_line;  ///< Hz, of the line that it may have instead; none where `other` has a value
  std::optional<std::size_t> other;  ///< the mode of the uncut body that may have the line instead
  double surprise = 0.0;  ///< standard deviations by which the line is above where its mode was expected, if neither
                          ///< has a value
};

/// Where a line comes from that the last tap does not have.
struct CarriedOver {
  std::size_t tap = 0;  ///< the last one that had the line, from 0 on
  double moved = 0.0;   ///< cents by which the cuts since then moved it
};

/// What all taps together tell.
struct Learned {
  std::vector<std::optional<fitting::Line>> lines;  ///< [partials] of the last tap, or carried over; none where it is
                                                    ///< doubted, or was never heard
  std::vector<std::optional<CarriedOver>> carried;  ///< [partials] none of a line of the last tap
  std::vector<double> computed;                     ///< [partials] Hz, of the deck's body with the asked cuts
  double probability = 1.0;                         ///< that these are their lines
  std::optional<Doubt> doubt;                       ///< where that is less than 99 %, or a line is a surprise
  std::vector<bool> is_doubted;             ///< [partials] whether it is less than 99 % certain which line it has,
                                            ///< or that it has none
  std::vector<Estimate> constants;          ///< of the material, which stays stable; none of a body of
                                            ///< several
  std::vector<Estimate> depths;             ///< [cuts] above those that were asked
  std::vector<Cut> cuts;                    ///< with the depths that they have, and one that makes the body as
                                            ///< thick as it is
  std::optional<scene::Material> material;  ///< with the constants that it has
};

/// Unknown are a common shift of all modes, the thickness of the body, the constants of its material, a deviation of
/// each mode that is its own, and the depth of each cut. They are normal and linear about the deck's body
/// with the asked cuts. A mode is not expected in a tap at a place where it hardly moves at right angles to the side.
/// Where the last tap misses a mode without doubt, the line of an earlier tap is carried over: to where the cuts since
/// then, and all else that was learned, put it. Its uncertainty grows by the errors of these cuts. A line is a surprise
/// where it is more than three standard deviations from where its mode was expected.
/// @param made  all cuts so far, as they were asked for
/// @param taps  at least one, in the order of time; the last one after all cuts
/// @throws std::runtime_error where a tap is not on the body, and what Workpiece::with() throws
[[nodiscard]] Learned learn(const Workpiece& piece, const std::vector<Cut>& made, const std::vector<Tap>& taps,
                            const Beliefs& beliefs);

}  // namespace idiophone::bench
