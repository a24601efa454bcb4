// Put before the C library by LD_PRELOAD in tests under mpirun: a rank that waits for another one sleeps for a moment
// where Open MPI only offers its core to others. After such an offer, Linux lets other programs go on for milliseconds:
// beside other tests, three ranks on two cores took four times as long.

#include <ctime>

extern "C" int sched_yield() noexcept {
  constexpr timespec moment{.tv_sec = 0, .tv_nsec = 1};  // Linux makes about 50 microseconds of it
  nanosleep(&moment, nullptr);
  return 0;
}
