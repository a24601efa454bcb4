#include "idiophone/run/loop/resources.hpp"

#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include <system_error>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::loop {

namespace {

constexpr double mega = 1e6;

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

}  // namespace idiophone::loop
