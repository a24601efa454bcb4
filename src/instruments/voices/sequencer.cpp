#include "sequencer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "events.hpp"

namespace idiophone::voices {

namespace {

constexpr std::int64_t change_length = 1024;  // audio samples, of a piece of the listener's path

std::vector<Instrument> instruments_of(std::vector<sound_maps::SoundMap> maps, int rate) {
  std::vector<Instrument> instruments;
  instruments.reserve(maps.size());
  for (sound_maps::SoundMap& map : maps) {
    instruments.emplace_back(std::move(map), rate);
  }
  return instruments;
}

void require_listeners(const std::vector<Instrument>& instruments) {
  const sound_maps::SoundMap& first = instruments.front().map();
  if (first.listeners.empty() || first.listeners.size() > most_receivers) {
    throw std::runtime_error(
        fmt::format("the sound map of {} has {} receivers; 1 to {} can be played. Give a listener "
                    "in the score",
                    first.body, first.listeners.size(), most_receivers));
  }
  for (const Instrument& instrument : instruments) {
    if (!std::ranges::equal(first.listeners, instrument.map().listeners, [](const auto& a, const auto& b) {
          return a.name == b.name && a.position == b.position;
        })) {
      throw std::runtime_error(
          fmt::format("the sound maps of {} and {} have different listeners; give a listener in "
                      "the score",
                      first.body, instrument.map().body));
    }
  }
}

void require_near(const Reception& reception, std::size_t receivers, const Instrument& instrument) {
  for (std::size_t r = 0; r < receivers; ++r) {
    const double way = reception.delay[r] / instrument.rate();
    if (way > longest_way) {
      throw std::runtime_error(fmt::format("a listener is {:.4g} s of sound away from {}; at most {} s can be played",
                                           way, instrument.map().body, longest_way));
    }
  }
}

}  // namespace

Sequencer::Sequencer(std::vector<sound_maps::SoundMap> maps, score::Score score_to_play, int rate)
    : score(std::move(score_to_play)),
      instruments(instruments_of(std::move(maps), rate)),
      receivers(score.listener ? score.listener->receivers.size() : instruments.front().map().listeners.size()),
      head(score.listener && score.listener->head
               ? std::make_unique<const receivers::HeadResponses>(score.listener->head->responses, rate)
               : nullptr),
      player(voices(), receivers, rate) {
  sort_events();
}

void Sequencer::sort_events() {
  std::ranges::stable_sort(score.events, {}, &score::ScoreEvent::time);
}

std::vector<Voice> Sequencer::voices() const {
  if (!score.listener) {
    require_listeners(instruments);
  }
  std::vector<Voice> voices;
  for (std::size_t body = 0; body < instruments.size(); ++body) {
    const Reception heard = reception(body, points(0.0));
    require_near(heard, receivers, instruments[body]);
    voices.emplace_back(instruments[body].turns(), receivers, heard, longest_way * rate());
  }
  return voices;
}

Reception Sequencer::reception(std::size_t body, std::span<const HearingPoint> points) const {
  const Instrument& instrument = instruments[body];
  Reception reception = points.empty() ? instrument.at_listeners() : instrument.at(points);
  if (head) {
    const auto& [look, up, responses, where] = *score.listener->head;
    const Vector3 way = instrument.map().centre - points.front().position;
    const Vector3 in_head(look.dot(way), up.cross(look).dot(way), up.dot(way));
    for (const std::vector<double>& ear : head->responses(head->nearest(in_head))) {
      reception.head.insert(reception.head.end(), ear.begin(), ear.end());
    }
  }
  return reception;
}

std::vector<HearingPoint> Sequencer::points(double time) const {
  std::vector<HearingPoint> points;
  for (std::size_t r = 0; score.listener && r < (head ? 1 : receivers); ++r) {
    const scene::Receiver& receiver = score.listener->receivers[r];
    const Vector3 position = score.listener->place(receiver, time).position + shift;
    points.push_back({.position = position, .axis = receiver.axis, .directivity = receiver.directivity});
  }
  return points;
}

std::optional<score::ScoreEvent> Sequencer::event_of(const drivers::Note& note) const {
  const auto found = std::ranges::find(score.notes, note.number, &score::NoteAction::note);
  if (found == score.notes.end()) {
    return {};
  }
  score::HammerBlow blow = found->blow;
  blow.hammer.speed *= note.velocity / 127.0;
  return score::ScoreEvent{note.time, found->body, blow};
}

void Sequencer::send_queued() {
  player.collect();
  while (!queued.empty() && player.send(queued.front())) {
    queued.pop_front();
  }
}

void Sequencer::queue_change(std::size_t body, Reception reception, std::int64_t start, std::int64_t length) {
  auto change = std::make_unique<ReceptionChange>();
  change->start = start;
  change->length = length;
  change->body = body;
  change->reception = std::move(reception);
  queued.emplace_back(std::move(change));
}

void Sequencer::queue_changes(std::span<const HearingPoint> points, std::int64_t start, std::int64_t length) {
  for (std::size_t body = 0; body < instruments.size(); ++body) {
    queue_change(body, reception(body, points), start, length);
  }
  change_end = start + length;
}

/// What is heard of the modes changes, too, but on a path the next piece does that.
void Sequencer::queue_tuning(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  instruments[body].tune(tuning);
  auto retuning = std::make_unique<Retuning>();
  retuning->start = start;
  retuning->body = body;
  retuning->turns = resonators::in_groups(instruments[body].turns());
  queued.emplace_back(std::move(retuning));
  if (!score.listener || !score.listener->path) {
    queue_change(body, reception(body, points(0.0)), start, change_length);
  }
}

void Sequencer::queue_path(std::int64_t until) {
  while (queued.empty() && score.listener && score.listener->path && change_end < until) {
    const double end = static_cast<double>(change_end + change_length) / rate();
    queue_changes(points(end), change_end, change_length);
    send_queued();
  }
}

void Sequencer::queue_move() {
  if (wanted && change_end <= player.now()) {
    const double way = (*wanted - shift).norm();
    const auto slowest = static_cast<std::int64_t>(3.0 * way / instruments.front().map().air_speed * rate());
    shift = *wanted;
    wanted.reset();
    queue_changes(points(0.0), player.now(), std::max(change_length, slowest));
    send_queued();
  }
}

void Sequencer::queue_events(std::int64_t until) {
  for (; next_event < score.events.size() && queued.empty(); ++next_event) {
    const score::ScoreEvent& event = score.events[next_event];
    const std::int64_t start = std::llround(event.time * rate());
    if (start >= until) {
      return;
    }
    if (const auto* tuning = std::get_if<score::Tuning>(&event.action)) {
      queue_tuning(event.body, *tuning, start);
    } else {
      std::ranges::move(commands_of(event, instruments[event.body], start, score.seed), std::back_inserter(queued));
    }
    send_queued();
  }
}

}  // namespace idiophone::voices
