#include "idiophone/instruments/proxies/engine.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "proxy_voice.hpp"

namespace idiophone::proxies {

namespace {

void check(const EngineOptions& options) {
  if (options.rate < 1000 || options.rate > 1'000'000) {
    throw std::invalid_argument("the audio rate must be from 1000 to 1 000 000 Hz");
  }
  if (options.largest_divisor < 1 || options.largest_divisor > 16 ||
      !std::has_single_bit(static_cast<unsigned>(options.largest_divisor))) {
    throw std::invalid_argument("the largest divisor of the rate must be 1, 2, 4, 8 or 16");
  }
  if (options.most_active == 0 || !(options.budget > 0.0) || !(options.significant_distance > 0.0)) {
    throw std::invalid_argument(
        "the number of active proxies, the budget and the significant distance must be above 0");
  }
}

bool is_finite(const Force& force) {
  return force.at.allFinite() && force.direction.allFinite() &&
         std::ranges::all_of(force.curve, [](double value) { return std::isfinite(value); });
}

}  // namespace

struct Engine::State {
  EngineOptions options;
  std::vector<Voice> voices;
  std::deque<Force> waiting;   // by their start, then in the order of their arrival
  std::deque<Tuning> tunings;  // likewise
  std::vector<Choice> choices;
  std::int64_t now = 0;
  std::vector<double> alone;  // of one body

  [[nodiscard]] std::size_t number_of(const Voice& voice) const {
    return static_cast<std::size_t>(&voice - voices.data());
  }

  /// @throws std::invalid_argument
  void require_body(std::size_t body) const;

  /// Active voices, those of the smallest priority first.
  [[nodiscard]] std::vector<Voice*> active() {
    std::vector<Voice*> active;
    for (Voice& voice : voices) {
      if (voice.is_active()) {
        active.push_back(&voice);
      }
    }
    std::ranges::stable_sort(active, {}, [](const Voice* voice) { return voice->priority(); });
    return active;
  }

  void note(const Voice& voice, Choice::Kind kind, std::int64_t sample) {
    const bool is_running = kind != Choice::Kind::refuse;
    const Detail detail = is_running ? voice.detail() : Detail{};
    choices.push_back({.sample = sample,
                       .body = number_of(voice),
                       .kind = kind,
                       .level = detail.level,
                       .divisor = detail.divisor,
                       .cost = detail.cost});
  }

  /// Fades out bodies of smaller priorities until one more body with this cost has room. Returns whether it has.
  bool make_room(double priority, double cost, std::int64_t sample) {
    const std::vector<Voice*> others = active();
    double total = cost;
    for (const Voice* voice : others) {
      total += voice->detail().cost;
    }
    std::size_t stopped = 0;
    while (others.size() - stopped >= options.most_active || total > options.budget) {
      if (stopped == others.size() || others[stopped]->priority() >= priority) {
        return false;
      }
      total -= others[stopped]->detail().cost;
      ++stopped;
    }
    for (std::size_t i = 0; i < stopped; ++i) {
      others[i]->fade();
      note(*others[i], Choice::Kind::stop, sample);
    }
    return true;
  }

  /// The most expensive detail for which there is budget. A body with the greatest priority may take all that is left;
  /// others may take their share of the budget, or the cheapest detail.
  [[nodiscard]] std::size_t choose_detail(const Voice& voice, double priority) {
    double left = options.budget;
    bool is_first = true;
    for (const Voice* other : active()) {
      left -= other->detail().cost;
      is_first &= other->priority() < priority;
    }
    const double share = options.budget / static_cast<double>(options.most_active);
    const double allowed = is_first ? left : std::min(left, share);
    const auto found =
        std::ranges::find_if(voice.details(), [&](const Detail& detail) { return detail.cost <= allowed; });
    return static_cast<std::size_t>(std::min(found, voice.details().end() - 1) - voice.details().begin());
  }

  void begin(Force force, std::int64_t sample) {
    Voice& voice = voices[force.body];
    const double priority = voice.priority_of(force);
    if (!voice.is_active()) {
      const double cost = voice.sounds() ? voice.detail().cost : voice.details().back().cost;
      if (!make_room(priority, cost, sample)) {
        note(voice, Choice::Kind::refuse, sample);
        return;
      }
      voice.sounds() ? voice.resume() : voice.begin(choose_detail(voice, priority), sample);
      note(voice, Choice::Kind::begin, sample);
    }
    force.start = std::max(force.start, sample);
    voice.add(std::move(force));
  }

  void begin_due(std::int64_t sample) {
    while (!tunings.empty() && tunings.front().start <= sample) {
      voices[tunings.front().body].tune(tunings.front());
      tunings.pop_front();
    }
    while (!waiting.empty() && waiting.front().start <= sample) {
      Force force = std::move(waiting.front());
      waiting.pop_front();
      begin(std::move(force), sample);
    }
  }

  /// From now until a force or tuning begins.
  [[nodiscard]] std::size_t samples_without_change(std::size_t most) const {
    auto end = now + static_cast<std::int64_t>(most);
    end = waiting.empty() ? end : std::min(end, waiting.front().start);
    end = tunings.empty() ? end : std::min(end, tunings.front().start);
    return static_cast<std::size_t>(end - now);
  }

  /// The next audio samples of the bodies that sound.
  /// @param render  renders a voice for some samples from an offset on. Returns the number after which it is stable
  template <class Render>
  void advance(std::size_t samples, const Render& render) {
    for (std::size_t done = 0; done < samples;) {
      begin_due(now);
      const std::size_t count = samples_without_change(samples - done);
      for (Voice& voice : voices) {
        if (voice.sounds()) {
          const std::size_t sounded = render(voice, done, count);
          if (!voice.sounds()) {
            note(voice, Choice::Kind::end, now + static_cast<std::int64_t>(sounded));
          }
        }
      }
      now += static_cast<std::int64_t>(count);
      done += count;
    }
  }
};

Force impact(std::size_t body, std::int64_t start, const Vector3& at, const Vector3& impulse, double duration,
             int rate) {
  const auto samples = static_cast<std::size_t>(std::max(1.0, std::ceil(duration * rate)));
  const double length = std::max(duration * rate, 1.0);
  Force force{.body = body, .start = start, .at = at, .direction = impulse.normalized(), .curve = {}};
  const auto share = [&](double sample) {  // of the impulse, until a sample
    return 0.5 * (1.0 - std::cos(std::numbers::pi * std::min(sample / length, 1.0)));
  };
  for (std::size_t i = 0; i < samples; ++i) {
    const auto sample = static_cast<double>(i);
    force.curve.push_back(impulse.norm() * rate * (share(sample + 1.0) - share(sample)));
  }
  return force;
}

Engine::Engine(const EngineOptions& options) : state_(std::make_unique<State>()) {
  check(options);
  state_->options = options;
}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

std::size_t Engine::add(BodyOptions body) {
  if (body.levels.empty()) {
    throw std::invalid_argument("body " + body.name + " has no level of detail");
  }
  state_->voices.emplace_back(std::move(body), state_->options);
  return state_->voices.size() - 1;
}

void Engine::move_listener(std::size_t body, const Vector3& listener) {
  state_->voices.at(body).move_listener(listener);
}

void Engine::State::require_body(std::size_t body) const {
  if (body >= voices.size()) {
    throw std::invalid_argument("there is no body " + std::to_string(body));
  }
}

void Engine::require_tunable(const Tuning& tuning) const {
  state_->require_body(tuning.body);
  state_->voices[tuning.body].require_tunable(tuning);
}

void Engine::add(const Tuning& tuning) {
  require_tunable(tuning);
  state_->tunings.insert(std::ranges::upper_bound(state_->tunings, tuning.start, {}, &Tuning::start), tuning);
}

void Engine::add(Force force) {
  state_->require_body(force.body);
  if (!is_finite(force)) {
    throw std::invalid_argument("a force on body " + state_->voices[force.body].body().name + " is not finite");
  }
  const auto later = std::ranges::upper_bound(state_->waiting, force.start, {}, &Force::start);
  state_->waiting.insert(later, std::move(force));
}

void Engine::render(std::span<double> sound) {
  std::ranges::fill(sound, 0.0);
  std::vector<double>& alone = state_->alone;
  state_->advance(sound.size(), [&](Voice& voice, std::size_t first, std::size_t count) {
    alone.assign(count, 0.0);
    const std::size_t sounded = voice.render(state_->now, alone);
    for (std::size_t i = 0; i < count; ++i) {
      sound[first + i] += voice.loudness() * alone[i];
    }
    return sounded;
  });
}

void Engine::render_each(std::span<double> sounds) {
  std::ranges::fill(sounds, 0.0);
  const std::size_t samples = state_->voices.empty() ? 0 : sounds.size() / state_->voices.size();
  state_->advance(samples, [&](Voice& voice, std::size_t first, std::size_t count) {
    return voice.render(state_->now, sounds.subspan(state_->number_of(voice) * samples + first, count));
  });
}

std::int64_t Engine::now() const {
  return state_->now;
}

std::int64_t Engine::delay() const {
  return UpSampler::delay(state_->options.largest_divisor);
}

std::vector<Choice> Engine::take_choices() {
  std::vector<Choice> choices = std::exchange(state_->choices, {});
  std::ranges::stable_sort(choices, {}, &Choice::sample);
  return choices;
}

std::size_t Engine::active() const {
  return state_->active().size();
}

double Engine::cost(std::size_t body, std::size_t level, int divisor) const {
  for (const Detail& detail : state_->voices.at(body).details()) {
    if (detail.level == level && detail.divisor == divisor) {
      return detail.cost;
    }
  }
  throw std::invalid_argument("there is no such level of detail");
}

}  // namespace idiophone::proxies
