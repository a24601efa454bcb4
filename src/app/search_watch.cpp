#include "search_watch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::app {

WatchedWork::WatchedWork(const std::string& parts, Style style, MPI_Comm communicator)
    : parts_(parts), communicator_(communicator), progress_(piece_progress(parts, style, communicator)) {}

PartWatch WatchedWork::watch() {
  return [this](std::size_t done, std::size_t expected) {
    const bool goes_on = progress_.report(static_cast<int>(done), static_cast<int>(expected), "");
    expected_ = expected;
    left_out_ = goes_on ? 0 : expected - done;
    return goes_on;
  };
}

void WatchedWork::note_left_out(std::vector<std::string>& notes) const {
  const std::uint64_t left_out = parallel::largest(left_out_, communicator_);
  const std::uint64_t expected = parallel::largest(expected_, communicator_);
  if (left_out > 0) {
    notes.push_back(fmt::format("{} of {} {}", left_out, expected, parts_));
  }
}

bool is_stopped(MPI_Comm communicator) {
  return parallel::largest(loop::noted_signal(), communicator) != 0;
}

void say_left_out(const std::vector<std::string>& left_out) {
  fmt::print(stderr, "idiophone: stopped by a signal, which left out {}\n", fmt::join(left_out, ", "));
}

}  // namespace idiophone::app
