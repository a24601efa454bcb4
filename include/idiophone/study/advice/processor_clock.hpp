#pragma once
// The clock by which the time of a run is estimated. Other programs on the machine do not change it.

#include <sys/resource.h>

namespace idiophone::advice {

/// Processor time of this rank and of the processes that it has started and that have ended, s.
[[nodiscard]] inline double processor_clock() {
  double seconds = 0.0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& part : {used.ru_utime, used.ru_stime}) {
      seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
  }
  return seconds;
}

}  // namespace idiophone::advice
