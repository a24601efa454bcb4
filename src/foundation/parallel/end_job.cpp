#include "idiophone/foundation/parallel/end_job.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/signal_safe.hpp"
#include "idiophone/foundation/terminal_text.hpp"

namespace idiophone::parallel {

void end_job(const std::string& why) {
  write_to_stderr(fmt::format("idiophone: rank {}: {}\n", rank_of(MPI_COMM_WORLD), for_terminal(why)));
  ::_exit(1);
}

Deadline::Deadline(std::chrono::seconds limit, std::string why)
    : watch_([limit, why = std::move(why)](const std::stop_token& in_time) {
        std::mutex mutex;
        std::unique_lock<std::mutex> guard(mutex);
        std::condition_variable_any sleep;
        if (!sleep.wait_for(guard, in_time, limit, [&] { return in_time.stop_requested(); })) {
          end_job(why);
        }
      }) {}

}  // namespace idiophone::parallel
