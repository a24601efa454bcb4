#pragma once
// The partials of a body that is struck several times, each once.

#include <span>
#include <vector>

#include "stretches.hpp"

namespace idiophone::report {

/// A partial that is the same in one or several impacts.
struct RecurringPartial {
  partials::Partial loudest;  ///< after the impact that excites it most
  std::size_t impacts = 0;    ///< after which it was found
};

/// Joins partials of different impacts that can't be told apart: those nearer than the resolution of the shorter
/// analysis, than half the width of the line at half its power, or than 5 cents. Leaves out what is 60 dB below the
/// strongest partial, and impacts whose search for partials ended early if that of another one did not.
/// @return by ascending frequency
[[nodiscard]] std::vector<RecurringPartial> recurring_partials(std::span<const Stretch> stretches);

}  // namespace idiophone::report
