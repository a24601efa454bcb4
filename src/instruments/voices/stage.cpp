#include "idiophone/instruments/voices/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/outputs/collected.hpp"
#include "idiophone/instruments/voices/map_detail.hpp"
#include "listener_change.hpp"

namespace idiophone::voices {

Stage::Stage(Audience audience, std::vector<std::unique_ptr<Voice>> voices, std::size_t channels, int rate)
    : audience_(std::move(audience)), voices_(std::move(voices)), channels_(channels), rate_(rate) {
  for (const auto& voice : voices_) {
    for (std::size_t body = 0; body < voice->bodies().size(); ++body) {
      bodies_.push_back(voice->bodies()[body]);
      places_.push_back({.voice = voice.get(), .body = body});
    }
    lead_ = std::max(lead_, voice->lead());
  }
}

std::optional<Vector3> Stage::centre(std::size_t body) const {
  return places_[body].voice->centre(places_[body].body);
}

void Stage::require_tunable(std::size_t body, const score::Tuning& tuning) const {
  places_[body].voice->require_tunable(places_[body].body, tuning);
}

void Stage::require_touchable(std::size_t body) const {
  places_[body].voice->require_touchable(places_[body].body);
}

void Stage::begin() {
  for (const auto& voice : voices_) {
    voice->begin();
  }
}

void Stage::end() {
  for (const auto& voice : voices_) {
    voice->end();
  }
}

void Stage::drive(const drivers::Drivers& drivers, std::int64_t until) {
  for (const auto& voice : voices_) {
    voice->attend();
  }
  follow_path(until + lead_);
  go_where_wanted();
  events_.clear();
  for (const auto& driver : drivers) {
    driver->ask(now(), until + lead_, events_);
  }
  std::ranges::stable_sort(events_, {}, &drivers::Event::start);
  for (const drivers::Event& event : events_) {
    try {
      perform(event);
    } catch (const std::exception& error) {
      if (event.sent == 0) {
        throw;
      }
      left_out_.warn(fmt::format("left out: {}", error.what()));
    }
  }
}

void Stage::perform(const drivers::Event& event) {
  if (const auto* move = std::get_if<drivers::ListenerMove>(&event.action)) {
    move_listener(move->position);
    return;
  }
  const auto& [voice, body] = places_[event.body];
  if (const auto* tuning = std::get_if<score::Tuning>(&event.action)) {
    voice->require_tunable(body, *tuning);
    voice->tune(body, *tuning, event.start);
  } else if (const auto* touch = std::get_if<drivers::Touching>(&event.action)) {
    voice->require_touchable(body);
    voice->touch(body, *touch, event.start);
  } else if (const auto* lead = std::get_if<drivers::TouchLead>(&event.action)) {
    voice->lead(body, *lead, event.start);
  } else if (const auto* detail = std::get_if<score::Detail>(&event.action)) {
    voice->set_detail(body, *detail, event.start);
    for (const auto& each : voices_) {
      if (detail->budget && each.get() != voice) {
        each->set_budget(*detail->budget, event.start);
      }
    }
  } else {
    voice->excite(body, std::get<drivers::Excitation>(event.action), event.sent);
  }
}

void Stage::move_listener(const Vector3& position) {
  if (!audience_.can_be_moved()) {
    throw std::runtime_error("the listener can only be moved if the score has a listener with a position");
  }
  for (const auto& voice : voices_) {
    voice->require_in_reach(position);
  }
  wanted_ = position;
}

void Stage::hear_at(ListenerPlace place) {
  change_end_ = place.start + place.length;
  for (const auto& voice : voices_) {
    voice->hear_at(place);
  }
}

void Stage::follow_path(std::int64_t until) {
  while (audience_.moves() && change_end_ < until) {
    const double end = static_cast<double>(change_end_ + change_length) / rate_;
    hear_at({.start = change_end_, .length = change_length, .points = audience_.points(end)});
  }
}

/// At no more than a third of the speed of sound.
void Stage::go_where_wanted() {
  constexpr double speed_of_sound = 343.0;  // m/s
  if (wanted_ && change_end_ <= now()) {
    const auto slowest = static_cast<std::int64_t>(3.0 * audience_.way_to(*wanted_) / speed_of_sound * rate_);
    audience_.move_to(*wanted_);
    wanted_.reset();
    hear_at({.start = now(), .length = std::max(change_length, slowest), .points = audience_.points(0.0)});
  }
}

VoiceReport Stage::report() const {
  VoiceReport sum;
  for (const auto& voice : voices_) {
    const VoiceReport report = voice->report();
    sum.waits.add(report.waits);
    sum.gaps += report.gaps;
    sum.doubts.insert(sum.doubts.end(), report.doubts.begin(), report.doubts.end());
  }
  return sum;
}

/// Voices that share a budget choose at the same samples, so a piece ends there.
void Stage::render(std::span<double> sound, std::int64_t clock) {
  std::ranges::fill(sound, 0.0);
  const std::int64_t begin = now_.load(std::memory_order_relaxed);
  for (std::int64_t sample = begin; !sound.empty(); sample = now()) {
    const std::int64_t until_choice = MapChoice::interval - sample % MapChoice::interval;
    const auto left = static_cast<std::int64_t>(sound.size() / channels_);
    const std::int64_t samples = std::min(left, until_choice);
    const std::span<double> piece = sound.first(static_cast<std::size_t>(samples) * channels_);
    for (const auto& voice : voices_) {
      voice->render(piece, clock + (sample - begin) * 1'000'000'000 / rate_);
    }
    now_.store(sample + samples, std::memory_order_release);
    sound = sound.subspan(piece.size());
  }
}

void perform(Stage& stage, const drivers::Drivers& drivers, outputs::Output& output, std::int64_t samples,
             const std::function<bool()>& interrupted) {
  const bool is_live = std::ranges::any_of(drivers, [](const auto& driver) { return driver->is_live(); });
  stage.drive(drivers, stage.now() + output.horizon());
  stage.begin();
  output.start(stage);
  const std::int64_t end = stage.now() + samples;
  bool goes_on = true;
  while (goes_on && !interrupted() && (is_live || stage.now() < end)) {
    stage.drive(drivers, stage.now() + output.horizon());
    goes_on = output.advance();
  }
  output.finish();
}

std::vector<double> rendered(Stage& stage, const drivers::Drivers& drivers, std::int64_t samples, std::int64_t block) {
  outputs::Collected output(samples, block);
  perform(stage, drivers, output, samples, [] { return false; });
  return output.take();
}

}  // namespace idiophone::voices
