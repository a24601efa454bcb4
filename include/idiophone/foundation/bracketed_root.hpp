#pragma once
// A zero of a continuous function of one variable, in a bounded number of steps.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace idiophone {

/// A zero between two arguments at which the function has different signs: the method of false position with
/// Illinois' halving, and bisection where that is slow.
/// @param low, high  in any order
/// @param at_low     value at `low`; likewise `at_high`
template <class Function>
double bracketed_root(const Function& function, double low, double high, double at_low, double at_high) {
  constexpr int most_steps = 200;  // bisection alone needs 64 for the digits and few for the size
  constexpr double digits = 2.0 * std::numeric_limits<double>::epsilon();
  for (int step = 0; step < most_steps && at_high != 0.0; ++step) {
    if (std::abs(high - low) <= digits * std::max(std::abs(low), std::abs(high))) {
      break;
    }
    const bool bisects = step % 4 == 3;
    double next = bisects ? 0.5 * (low + high) : high - at_high * (high - low) / (at_high - at_low);
    if (!(std::min(low, high) < next && next < std::max(low, high))) {
      next = 0.5 * (low + high);
    }
    const double at_next = function(next);
    if ((at_next < 0.0) != (at_high < 0.0)) {
      low = high;
      at_low = at_high;
    } else if (!bisects) {
      at_low *= 0.5;
    }
    high = next;
    at_high = at_next;
  }
  return high;
}

/// A zero of a function that is negative far below and positive far above: the search goes from `start` in steps that
/// grow, first by the value there.
template <class Function>
double root_from(const Function& function, double start) {
  constexpr int most_steps = 1000;  // any double is reached
  double here = start, value = function(start), way = -value;
  for (int step = 0; step < most_steps && value != 0.0; ++step) {
    const double next = here + way, at_next = function(next);
    if (next == here || (at_next < 0.0) != (value < 0.0)) {
      return bracketed_root(function, here, next, value, at_next);
    }
    here = next;
    value = at_next;
    way *= 2.0;
  }
  return here;
}

}  // namespace idiophone
