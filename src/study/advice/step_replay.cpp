#include "step_replay.hpp"

#include <algorithm>
#include <iterator>

namespace idiophone::advice {

namespace {

constexpr int links_of_a_message = 2;

}  // namespace

StepReplay::StepReplay(const RankSteps& steps, const Network& network)
    : steps_(steps), network_(network), ranks_(steps.ranks.size()) {
  const int count = static_cast<int>(std::ssize(ranks_));
  if (count > 0) {
    links_.assign(link_to(count - 1) + 1, {SharedLink<Crossing>(network.bandwidth)});
  }
  for (int rank = 0; rank < count; ++rank) {
    for (const Message& message : steps.ranks[rank].received) {
      const bool is_near = message.sender / network.ranks_on_host == rank / network.ranks_on_host;
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
    ranks_[rank].step = 0;
    start_step(rank, 0.0);
  }
  while (!events_.empty()) {
    const Event event = events_.top();
    events_.pop();
    play(event);
  }
  return ends_;
}

void StepReplay::play(const Event& event) {
  switch (event.kind) {
    case Kind::send:
      return send(event.index, event.time);
    case Kind::wait:
      ranks_[event.index].is_waiting = true;
      return end_step_if_ready(event.index, event.time);
    case Kind::enter:
      links_[event.index].shared.enter(event.time, event.bytes, event.message);
      return schedule_leave(event.index);
    case Kind::leave:
      if (Link& link = links_[event.index]; event.changes == link.changes) {  // nothing has entered or left since
        const Crossing message = link.shared.leave();
        schedule_leave(event.index);
        cross(message, event.time);
      }
      return;
    case Kind::arrive:  // through the memory of the host
      ranks_[event.message.receiver].crossed[event.message.step % 2] += links_of_a_message - 1;
      return cross(event.message, event.time);
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
    const Crossing crossing{message.receiver, step};
    if (message.is_near) {
      schedule(over_the_wire + message.bytes / way.bandwidth, Kind::arrive, 0, crossing);
    } else {
      schedule(over_the_wire, Kind::enter, link_from(rank), crossing, message.bytes);
      schedule(over_the_wire, Kind::enter, link_to(message.receiver), crossing, message.bytes);
    }
  }
  schedule(time + (waits_at_once(step) ? 0.0 : steps_.ranks[rank].inner), Kind::wait, rank);
}

void StepReplay::cross(Crossing message, double time) {
  ++ranks_[message.receiver].crossed[message.step % 2];
  end_step_if_ready(message.receiver, time);
}

void StepReplay::end_step_if_ready(int rank, double time) {
  Rank& state = ranks_[rank];
  const RankStep& work = steps_.ranks[rank];
  int& crossed = state.crossed[state.step % 2];
  if (!state.is_waiting || crossed < links_of_a_message * std::ssize(work.received)) {
    return;
  }
  crossed = 0;
  state.is_waiting = false;
  const double end = time + state.overhead + (waits_at_once(state.step) ? work.inner : 0.0);
  ends_[state.step] = std::max(ends_[state.step], end);
  if (++state.step < std::ssize(ends_)) {
    start_step(rank, end);
  }
}

void StepReplay::schedule_leave(int link) {
  const int changes = ++links_[link].changes;
  if (!links_[link].shared.empty()) {
    schedule(links_[link].shared.next_end(), Kind::leave, link, {}, 0.0, changes);
  }
}

void StepReplay::schedule(double time, Kind kind, int index, Crossing message, double bytes, int changes) {
  events_.push({time, scheduled_++, kind, index, message, bytes, changes});
}

bool StepReplay::waits_at_once(int step) const {
  const int period = steps_.steps_per_full_wait;
  return network_.is_shared_memory || (period > 0 && (step + 1) % period == 0);
}

}  // namespace idiophone::advice
