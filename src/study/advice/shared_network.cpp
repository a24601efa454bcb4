#include "shared_network.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace idiophone::advice {

SharedNetwork::SharedNetwork(int hosts, double bandwidth)
    : bandwidth_(bandwidth), sent_(hosts), received_(hosts), ways_from_(hosts), ways_to_(hosts) {}

void SharedNetwork::enter(double time, int from, int to, double bytes, Message message) {
  const int number = way_of(from, to);
  settle(ways_[number], time);
  ways_[number].messages.push({ways_[number].carried + bytes, message});
  ++sent_[from];
  ++received_[to];
  share_again(time, from, to);
  schedule(number);
}

double SharedNetwork::next_end() {
  while (!ends_.empty() && ends_.top().changes != ways_[ends_.top().way].changes) {
    ends_.pop();
  }
  return ends_.empty() ? std::numeric_limits<double>::infinity() : ends_.top().time;
}

SharedNetwork::Message SharedNetwork::leave() {
  const double time = next_end();
  const int number = ends_.top().way;
  Way& way = ways_[number];
  const Travelling first = way.messages.top();
  way.messages.pop();
  way.carried = first.end;
  way.time = time;
  --sent_[way.from];
  --received_[way.to];
  share_again(time, way.from, way.to);
  schedule(number);
  return first.message;
}

int SharedNetwork::way_of(int from, int to) {
  const auto [found, is_new] = numbers_.try_emplace({from, to}, static_cast<int>(std::ssize(ways_)));
  if (is_new) {
    ways_from_[from].push_back(found->second);
    ways_to_[to].push_back(found->second);
    ways_.push_back({.from = from, .to = to, .messages = {}});
  }
  return found->second;
}

void SharedNetwork::settle(Way& way, double time) {
  way.carried += (time - way.time) * way.rate;
  way.time = time;
}

void SharedNetwork::schedule(int number) {
  Way& way = ways_[number];
  ++way.changes;
  if (!way.messages.empty()) {
    ends_.push({way.time + (way.messages.top().end - way.carried) / way.rate, number, way.changes});
  }
}

/// After the number of messages of two hosts has changed.
void SharedNetwork::share_again(double time, int from, int to) {
  const auto share = [&](int number) {
    Way& way = ways_[number];
    if (way.messages.empty()) {
      return;
    }
    const double rate = bandwidth_ / std::max(sent_[way.from], received_[way.to]);
    if (rate != way.rate) {
      settle(way, time);
      way.rate = rate;
      schedule(number);
    }
  };
  std::ranges::for_each(ways_from_[from], share);
  std::ranges::for_each(ways_to_[to], share);
}

}  // namespace idiophone::advice
