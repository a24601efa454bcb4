#include "idiophone/timbre/language/live_sound.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "idiophone/foundation/deck/suggestion.hpp"
#include "idiophone/timbre/language/graph.hpp"
#include "idiophone/timbre/nodes/control.hpp"

namespace idiophone::timbre {

namespace {

void require(bool is_good, const std::string& expected) {
  if (!is_good) {
    throw std::invalid_argument("LiveSound: " + expected);
  }
}

void check(const LiveSoundOptions& options) {
  require(options.rate > 0, "the rate must be positive");
  require(options.smoothing >= 0.0 && std::isfinite(options.smoothing), "the smoothing must be a time, 0 or more");
  for (const auto* given : {&options.live, &options.constants}) {
    for (const auto& [name, value] : *given) {
      require(std::isfinite(value), fmt::format("the value of '{}' must be finite", name));
    }
  }
  for (const auto& [name, value] : options.constants) {
    require(!options.live.contains(name), fmt::format("'{}' is both live and constant", name));
  }
}

}  // namespace

LiveSound::LiveSound(const Tree& tree, const LiveSoundOptions& options) : rate_(options.rate) {
  check(options);
  const deck::Location where{tree.file.string(), 1, 1};
  Bindings bindings;
  for (const auto& [name, value] : options.live) {
    const auto control = controls_[name] = std::make_shared<Control>(value);
    bindings[name] = {.value = LiveValue{.control = control, .smoothing = options.smoothing}, .where = where};
  }
  for (const auto& [name, value] : options.constants) {
    bindings[name] = {.value = value, .where = where};
  }
  const std::uint64_t body = joined_seed(options.seed, 0);
  graph_ = std::make_unique<Graph>(
      tree, bindings,
      SoundStart{.rate = options.rate, .body_seed = body, .start_seed = joined_seed(body, options.start)});
}

LiveSound::~LiveSound() = default;
LiveSound::LiveSound(LiveSound&&) noexcept = default;
LiveSound& LiveSound::operator=(LiveSound&&) noexcept = default;

void LiveSound::set(const std::string& parameter, double value) {
  require(std::isfinite(value), fmt::format("'{}' must be finite", parameter));
  const auto control = controls_.find(parameter);
  if (control == controls_.end()) {
    std::vector<std::string> known;
    for (const auto& [name, unused] : controls_) {
      known.push_back(name);
    }
    require(false,
            fmt::format("'{}' is not among the live parameters{}", parameter, deck::suggestion(parameter, known)));
  }
  control->second->set(value);
}

void LiveSound::render(std::span<double> samples) {
  graph_->render(samples);
  for (const double sample : samples) {
    silent_samples_ = std::abs(sample) > level ? 0.0 : silent_samples_ + 1.0;
  }
}

double LiveSound::silent_for() const {
  return silent_samples_ / rate_;
}

}  // namespace idiophone::timbre
