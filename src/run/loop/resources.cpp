#include "idiophone/run/loop/resources.hpp"

#include <sched.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::loop {

namespace {

constexpr double mega = 1e6;

/// Of the machine that a rank runs on.
struct Processors {
  int ranks = 0;    ///< of this job
  int allowed = 0;  ///< processors that these ranks may use, all together
  int present = 0;
};

/// Collective over the ranks of a machine.
Processors processors_of(MPI_Comm machine) {
  cpu_set_t own = {};
  CPU_ZERO(&own);
  ::sched_getaffinity(0, sizeof own, &own);
  cpu_set_t all = {};
  CPU_ZERO(&all);
  for (const cpu_set_t& set : parallel::gather(own, machine)) {
    CPU_OR(&all, &all, &set);
  }
  return {parallel::size_of(machine), CPU_COUNT(&all), static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN))};
}

}  // namespace

double memory_of_machines(MPI_Comm communicator) {
  const double bytes = parallel::is_first_of_machine(communicator) ? static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                                                                         static_cast<double>(::sysconf(_SC_PAGESIZE))
                                                                   : 0.0;
  return parallel::sum(bytes, communicator);
}

double peak_memory() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void compare_memory(double needed, double present) {
  if (needed > present) {
    spdlog::warn(
        "the run needs about {:.0f} MB of memory, and there are {:.0f} MB: use more machines or a coarser mesh",
        needed / mega, present / mega);
  }
}

void compare_disk(double needed, const std::filesystem::path& directory) {
  std::error_code error;
  auto place = std::filesystem::absolute(directory);
  while (!std::filesystem::exists(place, error) && place.has_relative_path()) {
    place = place.parent_path();
  }
  const auto space = std::filesystem::space(place, error);
  if (error) {
    spdlog::warn("the free space of {} is not known: {}", place.string(), error.message());
  } else if (needed > static_cast<double>(space.available)) {
    spdlog::warn(
        "the files of the run need about {:.0f} MB, and {} has {:.0f} MB free: make room, give another "
        "--output-folder, or "
        "record less (output.frames_per_second, output.surface_motion, time.duration)",
        needed / mega, place.string(), static_cast<double>(space.available) / mega);
  }
}

void warn_of_bound_ranks(MPI_Comm communicator) {
  const Processors here = processors_of(parallel::RanksOfMachine(communicator).get());
  const auto all = parallel::gather(here, communicator);
  const auto is_bound = [](const Processors& p) { return p.allowed < p.ranks && p.allowed < p.present; };
  const auto worst = std::ranges::find_if(all, is_bound);
  if (worst != all.end() && parallel::is_root(communicator)) {
    spdlog::warn(
        "{} ranks of one machine may only use {} of its {} processors and wait for each other in every step: start "
        "mpirun with --bind-to none, or give the job more processors",
        worst->ranks, worst->allowed, worst->present);
  }
}

}  // namespace idiophone::loop
