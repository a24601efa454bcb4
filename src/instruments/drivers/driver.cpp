#include "idiophone/instruments/drivers/driver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone::drivers {

KnownEvents::KnownEvents(std::vector<Event> events) : events_(std::move(events)) {
  std::ranges::stable_sort(events_, {}, &Event::start);
}

void KnownEvents::ask(std::int64_t /*now*/, std::int64_t until, std::vector<Event>& events) {
  for (; next_ < events_.size() && events_[next_].start < until; ++next_) {
    events.push_back(std::move(events_[next_]));
  }
}

ScoreDriver::ScoreDriver(std::vector<score::ScoreEvent> events, std::uint64_t seed, int rate)
    : events_(std::move(events)), seed_(seed), rate_(rate) {
  std::ranges::stable_sort(events_, {}, &score::ScoreEvent::time);
}

void ScoreDriver::ask(std::int64_t /*now*/, std::int64_t until, std::vector<Event>& events) {
  for (; next_ < events_.size(); ++next_) {
    const std::int64_t start = std::llround(events_[next_].time * rate_);
    if (start >= until) {
      return;
    }
    events.push_back(event_of(events_[next_], start, seed_, rate_));
  }
}

}  // namespace idiophone::drivers
