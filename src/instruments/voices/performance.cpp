#include "idiophone/instruments/voices/performance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

#include "arrivals.hpp"
#include "events.hpp"
#include "idiophone/foundation/place_text.hpp"
#include "sequencer.hpp"

namespace idiophone::voices {

namespace {

constexpr std::int64_t stroke_lead = 512;  // audio samples by which a stroke begins later, so that all of it is there

void require_no_tension(const score::ScoreEvent& event) {
  if (const auto* tuning = std::get_if<score::Tuning>(&event.action); tuning != nullptr && tuning->tension != 1.0) {
    throw std::runtime_error("tune: only proxies have a tension; sound maps have size and friction");
  }
}

}  // namespace

Performance::Performance(std::vector<sound_maps::SoundMap> maps, score::Score score, int rate)
    : sequencer_(std::make_unique<Sequencer>(std::move(maps), std::move(score), rate)) {
  std::ranges::for_each(sequencer_->score.events, require_no_tension);
}

Performance::~Performance() = default;

const score::Score& Performance::score() const {
  return sequencer_->score;
}

int Performance::rate() const {
  return sequencer_->rate();
}

std::size_t Performance::receivers() const {
  return sequencer_->receivers;
}

std::size_t Performance::modes() const {
  std::size_t sum = 0;
  for (const Instrument& instrument : sequencer_->instruments) {
    sum += instrument.modes();
  }
  return sum;
}

std::size_t Performance::add(const std::vector<drivers::Note>& notes) {
  std::size_t unknown = 0;
  for (const drivers::Note& note : notes) {
    if (const std::optional<score::ScoreEvent> event = sequencer_->event_of(note)) {
      sequencer_->score.events.push_back(*event);
    } else {
      ++unknown;
    }
  }
  sequencer_->sort_events();
  return unknown;
}

void Performance::feed(std::int64_t until) {
  sequencer_->send_queued();
  sequencer_->queue_path(until);
  sequencer_->queue_move();
  sequencer_->queue_events(until);
}

void Performance::play(const score::ScoreEvent& event) {
  require_no_tension(event);
  const std::int64_t sent = std::chrono::steady_clock::now().time_since_epoch().count();
  if (!sequencer_->queued.empty()) {
    throw std::runtime_error("too much is played at once; this is left out");
  }
  if (const auto* tuning = std::get_if<score::Tuning>(&event.action)) {
    sequencer_->queue_tuning(event.body, *tuning, now());
    sequencer_->send_queued();
    return;
  }
  const bool moves = std::holds_alternative<score::Stroke>(event.action);
  std::vector<Command> commands = commands_of(event, sequencer_->instruments[event.body],
                                              now() + (moves ? stroke_lead : 0), sequencer_->score.seed);
  if (!moves) {
    std::get<std::unique_ptr<Excitation>>(commands.front())->sent = sent;
  }
  std::ranges::move(commands, std::back_inserter(sequencer_->queued));
  sequencer_->send_queued();
}

bool Performance::play(const drivers::Note& note) {
  const std::optional<score::ScoreEvent> event = sequencer_->event_of(note);
  if (event) {
    play(*event);
  }
  return event.has_value();
}

void Performance::move_listener(const Vector3& position) {
  const std::optional<scene::Listener>& listener = sequencer_->score.listener;
  if (!listener || listener->path) {
    throw std::runtime_error("the listener can only be moved if the score has a listener with a position");
  }
  for (const Instrument& instrument : sequencer_->instruments) {
    if ((position - instrument.map().centre).norm() > 0.99 * longest_way * instrument.map().air_speed) {
      throw std::runtime_error(
          fmt::format("{} is too far away from {} for a listener", to_text(position), instrument.map().body));
    }
  }
  Vector3 middle = Vector3::Zero();
  for (const scene::Receiver& receiver : listener->receivers) {
    middle += receiver.position / static_cast<double>(receivers());
  }
  sequencer_->wanted = position - middle;
}

void Performance::render(std::span<double> sound, std::int64_t clock) {
  sequencer_->player.render(sound, clock);
}

std::int64_t Performance::now() const {
  return sequencer_->player.now();
}

Waits Performance::waits() const {
  return sequencer_->player.waits();
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

}  // namespace idiophone::voices
