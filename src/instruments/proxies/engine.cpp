#include "idiophone/instruments/proxies/engine.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "engine_state.hpp"

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
  if (!(options.behind > 0.0) || options.behind > 1.0) {
    throw std::invalid_argument("the factor of what is behind the listener must be above 0, at most 1");
  }
}

bool is_finite(const Force& force) {
  return force.at.allFinite() && force.direction.allFinite() &&
         std::ranges::all_of(force.curve, [](double value) { return std::isfinite(value); });
}

}  // namespace

void Engine::State::note(const Voice& voice, Choice::Kind kind, std::int64_t sample) {
  const bool is_running = kind != Choice::Kind::refuse;
  const Detail detail = is_running ? voice.detail() : Detail{};
  choices.push_back({.sample = sample,
                     .body = number_of(voice),
                     .kind = kind,
                     .level = detail.level,
                     .divisor = detail.divisor,
                     .cost = detail.cost});
}

void Engine::State::begin(Force force, std::int64_t sample) {
  if (const std::size_t present = present_body(force.body, force.at); present != force.body) {
    force.direction *= mass_of(present) / mass_of(force.body);
    force.body = present;
  }
  Voice& voice = voices[force.body];
  const double priority = voice.priority_of(force);
  if (!voice.is_active()) {
    const double cost = voice.sounds() ? voice.detail().cost : voice.smallest_cost();
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

void Engine::State::begin_due(std::int64_t sample) {
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

std::size_t Engine::State::samples_without_change(std::size_t most) const {
  if (std::ranges::any_of(voices, [](const Voice& voice) { return voice.is_breakable(); })) {
    return std::min<std::size_t>(most, 1);
  }
  auto end = now + static_cast<std::int64_t>(most);
  end = waiting.empty() ? end : std::min(end, waiting.front().start);
  end = tunings.empty() ? end : std::min(end, tunings.front().start);
  return static_cast<std::size_t>(end - now);
}

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
  const bool shall_break = std::isfinite(body.strength.tensile);
  if (shall_break && std::ranges::any_of(body.levels, &Lattice::is_under_tension)) {
    throw std::invalid_argument("body " + body.name +
                                " has springs under tension at rest; such a body can't break, leave out its strength");
  }
  if (shall_break && std::ranges::any_of(body.levels, &Lattice::has_own_springs)) {
    throw std::invalid_argument("body " + body.name +
                                " has single springs with values of their own, which its pieces would lose; leave out "
                                "these values or its strength");
  }
  std::vector<Voice>& voices = state_->voices;
  const auto faded =
      std::ranges::find_if(state_->removed, [&](std::size_t number) { return !voices[number].sounds(); });
  if (faded == state_->removed.end()) {
    voices.emplace_back(std::move(body), state_->options, voices.size());
    return voices.size() - 1;
  }
  const std::size_t number = *faded;
  voices[number] = Voice(std::move(body), state_->options, number);
  state_->removed.erase(faded);
  return number;
}

void Engine::remove(std::size_t body) {
  state_->require_body(body);
  if (!is_whole(body) || state_->parents.contains(body)) {
    throw std::invalid_argument("body " + state_->voices[body].body().name + " broke, so it can't be removed");
  }
  std::erase_if(state_->waiting, [&](const Force& force) { return force.body == body; });
  std::erase_if(state_->tunings, [&](const Tuning& tuning) { return tuning.body == body; });
  state_->voices[body].fade();
  state_->removed.insert(body);
}

bool Engine::sounds(std::size_t body) const {
  return state_->voices.at(body).sounds();
}

void Engine::move_listener(std::size_t body, const Vector3& listener, const Vector3& front) {
  state_->voices.at(body).move_listener(listener, front);
}

void Engine::set_level(std::size_t body, std::optional<std::size_t> level) {
  state_->require_body(body);
  if (level) {
    require_level(body, *level);
  }
  state_->voices[body].set_level(level);
}

void Engine::require_level(std::size_t body, std::size_t level) const {
  state_->require_body(body);
  if (level >= state_->voices[body].body().levels.size()) {
    throw std::invalid_argument("body " + state_->voices[body].body().name + " has no level " + std::to_string(level));
  }
}

void Engine::set_priority(std::size_t body, double priority) {
  state_->require_body(body);
  if (!std::isfinite(priority)) {
    throw std::invalid_argument("a priority must be finite");
  }
  state_->voices[body].set_priority(priority);
}

void Engine::set_limits(double budget, std::size_t most_active) {
  EngineOptions changed = state_->options;
  changed.budget = budget;
  changed.most_active = most_active;
  check(changed);
  state_->options = changed;
  state_->keep_limits();
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
  const std::size_t rows = state_->voices.size();
  const std::size_t samples = sounds.size() / std::max<std::size_t>(1, rows);
  state_->advance(samples, [&](Voice& voice, std::size_t first, std::size_t count) {
    const std::size_t row = state_->ancestor(state_->number_of(voice), rows);
    return voice.render(state_->now, sounds.subspan(row * samples + first, count));
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

std::vector<Fracture> Engine::take_fractures() {
  return std::exchange(state_->fractures, {});
}

std::size_t Engine::active() const {
  return state_->active().size();
}

const BodyOptions& Engine::body(std::size_t body) const {
  return state_->voices.at(body).body();
}

bool Engine::is_whole(std::size_t body) const {
  return !state_->pieces.contains(body);
}

Fragment Engine::motion(std::size_t body) const {
  return state_->voices.at(body).fragment();
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
