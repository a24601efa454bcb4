#include "idiophone/playing/performance.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <optional>
#include <stdexcept>

#include "arrivals.hpp"
#include "events.hpp"
#include "idiophone/listening/head_responses.hpp"
#include "idiophone/place_text.hpp"
#include "instrument.hpp"
#include "player.hpp"

namespace idiophone::playing {

namespace {

constexpr std::int64_t change_length = 1024;  // audio samples, of a piece of the listener's path
constexpr double longest_way = 1.0;           // s, of sound from a body to a listener
constexpr std::int64_t stroke_lead = 512;  // audio samples by which a stroke begins later, so that all of it is there

void require_no_tension(const scene::ScoreEvent& event) {
  if (const auto* tuning = std::get_if<scene::Tuning>(&event.action); tuning != nullptr && tuning->tension != 1.0) {
    throw std::runtime_error("tune: only proxies have a tension; sound maps have size and friction");
  }
}

std::vector<Instrument> instruments_of(std::vector<store::SoundMap> maps, int rate) {
  std::vector<Instrument> instruments;
  instruments.reserve(maps.size());
  for (store::SoundMap& map : maps) {
    instruments.emplace_back(std::move(map), rate);
  }
  return instruments;
}

void require_listeners(const std::vector<Instrument>& instruments) {
  const store::SoundMap& first = instruments.front().map();
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

struct Performance::State {
  scene::Score score;
  std::vector<Instrument> instruments;
  std::size_t receivers;
  std::unique_ptr<const listening::HeadResponses> head;  // of the score's listener; or null
  Vector3 shift = Vector3::Zero();  // of the listener from where the score has it, m; the player's start needs it
  Player player;
  std::size_t next_event = 0;
  std::int64_t change_end = 0;    // audio sample at which the last change of reception is over
  std::deque<Command> queued;     // not sent yet
  std::optional<Vector3> wanted;  // shift that move_listener() asks for, not queued yet, m

  State(std::vector<store::SoundMap> maps, scene::Score score_to_play, int rate)
      : score(std::move(score_to_play)),
        instruments(instruments_of(std::move(maps), rate)),
        receivers(score.listener ? score.listener->receivers.size() : instruments.front().map().listeners.size()),
        head(score.listener && score.listener->head
                 ? std::make_unique<const listening::HeadResponses>(score.listener->head->responses, rate)
                 : nullptr),
        player(voices(), receivers, rate) {
    sort_events();
  }

  [[nodiscard]] int rate() const { return instruments.front().rate(); }
  void sort_events() { std::ranges::stable_sort(score.events, {}, &scene::ScoreEvent::time); }
  [[nodiscard]] std::vector<Voice> voices() const;
  [[nodiscard]] std::vector<HearingPoint> points(double time) const;
  [[nodiscard]] std::optional<scene::ScoreEvent> event_of(const Note& note) const;
  [[nodiscard]] Reception reception(std::size_t body, std::span<const HearingPoint> points) const;
  void queue_change(std::size_t body, Reception reception, std::int64_t start, std::int64_t length);
  void queue_changes(std::span<const HearingPoint> points, std::int64_t start, std::int64_t length);
  void queue_tuning(std::size_t body, const scene::Tuning& tuning, std::int64_t start);
  void queue_path(std::int64_t until);
  void queue_move();
  void queue_events(std::int64_t until);
  void send_queued();
};

std::vector<Voice> Performance::State::voices() const {
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

/// Of the listener of the score, or of those of the sound map.
Reception Performance::State::reception(std::size_t body, std::span<const HearingPoint> points) const {
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

std::vector<HearingPoint> Performance::State::points(double time) const {
  std::vector<HearingPoint> points;
  for (std::size_t r = 0; score.listener && r < (head ? 1 : receivers); ++r) {
    const scene::Receiver& receiver = score.listener->receivers[r];
    const Vector3 position = score.listener->place(receiver, time).position + shift;
    points.push_back({.position = position, .axis = receiver.axis, .directivity = receiver.directivity});
  }
  return points;
}

std::optional<scene::ScoreEvent> Performance::State::event_of(const Note& note) const {
  const auto found = std::ranges::find(score.notes, note.number, &scene::NoteAction::note);
  if (found == score.notes.end()) {
    return {};
  }
  scene::HammerBlow blow = found->blow;
  blow.hammer.speed *= note.velocity / 127.0;
  return scene::ScoreEvent{note.time, found->body, blow};
}

void Performance::State::send_queued() {
  player.collect();
  while (!queued.empty() && player.send(queued.front())) {
    queued.pop_front();
  }
}

void Performance::State::queue_change(std::size_t body, Reception reception, std::int64_t start, std::int64_t length) {
  auto change = std::make_unique<ReceptionChange>();
  change->start = start;
  change->length = length;
  change->body = body;
  change->reception = std::move(reception);
  queued.emplace_back(std::move(change));
}

void Performance::State::queue_changes(std::span<const HearingPoint> points, std::int64_t start, std::int64_t length) {
  for (std::size_t body = 0; body < instruments.size(); ++body) {
    queue_change(body, reception(body, points), start, length);
  }
  change_end = start + length;
}

/// What is heard of the modes changes, too, but on a path the next piece does that.
void Performance::State::queue_tuning(std::size_t body, const scene::Tuning& tuning, std::int64_t start) {
  instruments[body].tune(tuning);
  auto retuning = std::make_unique<Retuning>();
  retuning->start = start;
  retuning->body = body;
  retuning->turns = in_groups(instruments[body].turns());
  queued.emplace_back(std::move(retuning));
  if (!score.listener || !score.listener->path) {
    queue_change(body, reception(body, points(0.0)), start, change_length);
  }
}

void Performance::State::queue_path(std::int64_t until) {
  while (queued.empty() && score.listener && score.listener->path && change_end < until) {
    const double end = static_cast<double>(change_end + change_length) / rate();
    queue_changes(points(end), change_end, change_length);
    send_queued();
  }
}

void Performance::State::queue_move() {
  if (wanted && change_end <= player.now()) {
    const double way = (*wanted - shift).norm();
    const auto slowest = static_cast<std::int64_t>(3.0 * way / instruments.front().map().air_speed * rate());
    shift = *wanted;
    wanted.reset();
    queue_changes(points(0.0), player.now(), std::max(change_length, slowest));
    send_queued();
  }
}

void Performance::State::queue_events(std::int64_t until) {
  for (; next_event < score.events.size() && queued.empty(); ++next_event) {
    const scene::ScoreEvent& event = score.events[next_event];
    const std::int64_t start = std::llround(event.time * rate());
    if (start >= until) {
      return;
    }
    if (const auto* tuning = std::get_if<scene::Tuning>(&event.action)) {
      queue_tuning(event.body, *tuning, start);
    } else {
      std::ranges::move(commands_of(event, instruments[event.body], start, score.seed), std::back_inserter(queued));
    }
    send_queued();
  }
}

Performance::Performance(std::vector<store::SoundMap> maps, scene::Score score, int rate)
    : state_(std::make_unique<State>(std::move(maps), std::move(score), rate)) {
  std::ranges::for_each(state_->score.events, require_no_tension);
}

Performance::~Performance() = default;

const scene::Score& Performance::score() const {
  return state_->score;
}

int Performance::rate() const {
  return state_->rate();
}

std::size_t Performance::receivers() const {
  return state_->receivers;
}

std::size_t Performance::modes() const {
  std::size_t sum = 0;
  for (const Instrument& instrument : state_->instruments) {
    sum += instrument.modes();
  }
  return sum;
}

std::size_t Performance::add(const std::vector<Note>& notes) {
  std::size_t unknown = 0;
  for (const Note& note : notes) {
    if (const std::optional<scene::ScoreEvent> event = state_->event_of(note)) {
      state_->score.events.push_back(*event);
    } else {
      ++unknown;
    }
  }
  state_->sort_events();
  return unknown;
}

void Performance::feed(std::int64_t until) {
  state_->send_queued();
  state_->queue_path(until);
  state_->queue_move();
  state_->queue_events(until);
}

void Performance::play(const scene::ScoreEvent& event) {
  require_no_tension(event);
  const std::int64_t sent = std::chrono::steady_clock::now().time_since_epoch().count();
  if (!state_->queued.empty()) {
    throw std::runtime_error("too much is played at once; this is left out");
  }
  if (const auto* tuning = std::get_if<scene::Tuning>(&event.action)) {
    state_->queue_tuning(event.body, *tuning, now());
    state_->send_queued();
    return;
  }
  const bool moves = std::holds_alternative<scene::Stroke>(event.action);
  std::vector<Command> commands =
      commands_of(event, state_->instruments[event.body], now() + (moves ? stroke_lead : 0), state_->score.seed);
  if (!moves) {
    std::get<std::unique_ptr<Excitation>>(commands.front())->sent = sent;
  }
  std::ranges::move(commands, std::back_inserter(state_->queued));
  state_->send_queued();
}

bool Performance::play(const Note& note) {
  const std::optional<scene::ScoreEvent> event = state_->event_of(note);
  if (event) {
    play(*event);
  }
  return event.has_value();
}

void Performance::move_listener(const Vector3& position) {
  const std::optional<scene::Listener>& listener = state_->score.listener;
  if (!listener || listener->path) {
    throw std::runtime_error("the listener can only be moved if the score has a listener with a position");
  }
  for (const Instrument& instrument : state_->instruments) {
    if ((position - instrument.map().centre).norm() > 0.99 * longest_way * instrument.map().air_speed) {
      throw std::runtime_error(
          fmt::format("{} is too far away from {} for a listener", to_text(position), instrument.map().body));
    }
  }
  Vector3 middle = Vector3::Zero();
  for (const scene::Receiver& receiver : listener->receivers) {
    middle += receiver.position / static_cast<double>(receivers());
  }
  state_->wanted = position - middle;
}

void Performance::render(std::span<double> sound, std::int64_t clock) {
  state_->player.render(sound, clock);
}

std::int64_t Performance::now() const {
  return state_->player.now();
}

Waits Performance::waits() const {
  return state_->player.waits();
}

double shortest_delay() {
  return Arrivals::nearest();
}

std::vector<double> rendered(Performance& performance, std::int64_t samples, std::int64_t block) {
  const std::size_t width = performance.receivers();
  std::vector<double> sound(static_cast<std::size_t>(samples) * width);
  for (std::int64_t first = 0; first < samples; first += block) {
    const std::int64_t count = std::min(block, samples - first);
    performance.feed(performance.now() + count);
    performance.render(
        std::span(sound).subspan(static_cast<std::size_t>(first) * width, static_cast<std::size_t>(count) * width));
  }
  return sound;
}

}  // namespace idiophone::playing
