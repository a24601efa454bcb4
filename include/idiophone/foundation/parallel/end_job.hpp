#pragma once
// The end of a job whose ranks can't agree any more, because they wait for each other in different calls.

#include <chrono>
#include <string>
#include <thread>

namespace idiophone::parallel {

/// Prints "idiophone: rank N: why" and leaves with status 1, upon which the launcher ends the other ranks. Files remain
/// as after kill -9.
[[noreturn]] void end_job(const std::string& why);

/// Whether the last agreement of the ranks was a failure (share_failure(), agree()), which all of them throw. While it
/// ends them, they still come to the same collective calls.
[[nodiscard]] bool ranks_fail_together();

/// Ends the job, as end_job() does, if it lives longer than its limit.
class Deadline {
 public:
  Deadline(std::chrono::seconds limit, std::string why);

 private:
  std::jthread watch_;
};

}  // namespace idiophone::parallel
