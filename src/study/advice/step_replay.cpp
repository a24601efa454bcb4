#include "step_replay.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace idiophone::advice {

StepReplay::StepReplay(const RankSteps& steps, const Network& network)
    : steps_(steps),
      network_(network),
      ranks_(steps.ranks.size()),
      between_hosts_(host_of(static_cast<int>(steps.ranks.size())) + 1, network.bandwidth) {
  for (int rank = 0; rank < std::ssize(ranks_); ++rank) {
    for (const Message& message : steps.ranks[rank].received) {
      const bool is_near = host_of(message.sender) == host_of(rank);
      ranks_[rank].overhead += (is_near ? shared_memory : network).overhead;
      ranks_.at(message.sender).sent.push_back({rank, message.bytes, is_near});
    }
  }
}

double StepReplay::computing(int rank) const {
  return steps_.ranks[rank].computing + 2 * ranks_[rank].overhead;
}

std::vector<double> StepReplay::ends(int count) {
  ends_.assign(count, 0.0);
  for (int rank = 0; rank < std::ssize(ranks_); ++rank) {
    ranks_[rank].arrived.assign(count, 0);
    start_step(rank, 0.0);
  }
  while (!events_.empty() || std::isfinite(between_hosts_.next_end())) {
    const double end = between_hosts_.next_end();
    if (events_.empty() || end < events_.top().time) {
      arrive(between_hosts_.leave(), end);
    } else {
      const Event event = events_.top();
      events_.pop();
      play(event);
    }
  }
  return ends_;
}

void StepReplay::play(const Event& event) {
  switch (event.kind) {
    case Kind::send:
      return send(event.rank, event.time);
    case Kind::wait:
      ranks_[event.rank].is_waiting = true;
      return end_step_if_ready(event.rank, event.time);
    case Kind::enter:
      return between_hosts_.enter(event.time, host_of(event.rank), host_of(event.message.receiver), event.bytes,
                                  event.message);
    case Kind::arrive:
      return arrive(event.message, event.time);
  }
}

void StepReplay::start_step(int rank, double time) {
  const RankStep& step = steps_.ranks[rank];
  schedule(time + step.computing - step.inner + ranks_[rank].overhead, Kind::send, rank);
}

void StepReplay::send(int rank, double time) {
  const int step = ranks_[rank].step;
  for (const Outgoing& message : ranks_[rank].sent) {
    const Network& way = message.is_near ? shared_memory : network_;
    const double over_the_wire = time + way.latency - 2 * way.overhead;
    if (message.is_near) {
      schedule(over_the_wire + message.bytes / way.bandwidth, Kind::arrive, rank, {message.receiver, step});
    } else {
      schedule(over_the_wire, Kind::enter, rank, {message.receiver, step}, message.bytes);
    }
  }
  schedule(time + (waits_at_once(step) ? 0.0 : steps_.ranks[rank].inner), Kind::wait, rank);
}

void StepReplay::arrive(SharedNetwork::Message message, double time) {
  ++ranks_[message.receiver].arrived[message.step];
  end_step_if_ready(message.receiver, time);
}

void StepReplay::end_step_if_ready(int rank, double time) {
  Rank& state = ranks_[rank];
  const RankStep& work = steps_.ranks[rank];
  if (!state.is_waiting || state.arrived[state.step] < std::ssize(work.received)) {
    return;
  }
  state.is_waiting = false;
  const double end = time + state.overhead + (waits_at_once(state.step) ? work.inner : 0.0);
  ends_[state.step] = std::max(ends_[state.step], end);
  if (++state.step < std::ssize(ends_)) {
    start_step(rank, end);
  }
}

void StepReplay::schedule(double time, Kind kind, int rank, SharedNetwork::Message message, double bytes) {
  events_.push({time, scheduled_++, kind, rank, message, bytes});
}

bool StepReplay::waits_at_once(int step) const {
  const int period = steps_.steps_per_full_wait;
  return network_.is_shared_memory || (period > 0 && (step + 1) % period == 0);
}

}  // namespace idiophone::advice
