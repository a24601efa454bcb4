// Put before MPI by LD_PRELOAD: sends a signal at the start of an audio block, so that tests of stopping do not depend
// on the machine's speed. In the environment: SIGNAL (a number), SIGNAL_BLOCK (from 1), SIGNAL_RANK, and SIGNAL_PID
// where the signal is for another process than that rank.

#include <mpi.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace {

int number(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : otherwise;
}

}  // namespace

extern "C" int MPI_Pcontrol(const int level, ...) {
  static int block = 0;
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  block += level;
  if (level == 1 && block == number("SIGNAL_BLOCK", 1) && rank == number("SIGNAL_RANK", 0)) {
    const pid_t process = number("SIGNAL_PID", getpid());
    kill(process, number("SIGNAL", SIGTERM));
    if (process != getpid()) {
      sleep(1);  // until whoever got it has passed it on to the ranks
    }
  }
  return MPI_SUCCESS;
}
