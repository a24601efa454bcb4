#pragma once
// Time on the wall, and the parts of a program in which no rank waits for all others.

#include <mpi.h>

namespace idiophone::parallel {

/// Wall-clock time since a moment in the past, s.
[[nodiscard]] inline double wall_time() {
  return MPI_Wtime();
}

/// While it exists, this rank makes no collective call. Tools that watch MPI see it by MPI_Pcontrol(1) and (0).
class NoCollectives {
 public:
  NoCollectives() { MPI_Pcontrol(1); }
  ~NoCollectives() { MPI_Pcontrol(0); }
  NoCollectives(const NoCollectives&) = delete;
  NoCollectives& operator=(const NoCollectives&) = delete;
  NoCollectives(NoCollectives&&) = delete;
  NoCollectives& operator=(NoCollectives&&) = delete;
};

}  // namespace idiophone::parallel
