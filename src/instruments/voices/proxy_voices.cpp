#include "idiophone/instruments/voices/proxy_voices.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace idiophone::voices {

namespace {

proxies::Tuning tuning_of(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  return {.body = body, .start = start, .tension = tuning.tension, .friction = tuning.friction, .size = tuning.size};
}

}  // namespace

proxies::Force proxy_force(std::size_t body, const resonators::PointForce& force) {
  proxies::Force found{.body = body, .start = force.start, .at = force.at, .direction = force.direction, .curve = {}};
  for (const resonators::ForcePiece& piece : force.force) {
    found.curve.push_back(piece.mean);
  }
  return found;
}

ProxyVoices::ProxyVoices(proxies::Engine engine, std::vector<std::string> bodies, std::vector<Vector3> centres,
                         std::size_t channels)
    : engine_(std::move(engine)), bodies_(std::move(bodies)), centres_(std::move(centres)), channels_(channels) {}

void ProxyVoices::require_tunable(std::size_t body, const score::Tuning& tuning) const {
  engine_.require_tunable(tuning_of(body, tuning, 0));
}

void ProxyVoices::excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t /*sent*/) {
  for (const resonators::PointForce& force : excitation.forces) {
    engine_.add(proxy_force(body, force));
  }
}

void ProxyVoices::tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  engine_.add(tuning_of(body, tuning, start));
}

void ProxyVoices::hear_at(const ListenerPlace& place) {
  moves_.push_back(place);
}

/// The engine's next samples. The listener is at each place from the audio sample on at which it arrives there.
void ProxyVoices::advance(std::span<double> sound) {
  while (!sound.empty()) {
    while (!moves_.empty() && moves_.front().start + moves_.front().length <= engine_.now()) {
      for (std::size_t body = 0; body < bodies_.size(); ++body) {
        engine_.move_listener(body, middle_of(moves_.front().points));
      }
      moves_.erase(moves_.begin());
    }
    std::size_t count = sound.size();
    if (!moves_.empty()) {
      const auto until = static_cast<std::size_t>(moves_.front().start + moves_.front().length - engine_.now());
      count = std::min(count, until);
    }
    engine_.render(sound.first(count));
    sound = sound.subspan(count);
  }
}

void ProxyVoices::render(std::span<double> sound, std::int64_t /*clock*/) {
  if (engine_.now() == 0) {  // what comes late comes early enough
    mono_.resize(static_cast<std::size_t>(engine_.delay()));
    advance(mono_);
  }
  mono_.resize(sound.size() / channels_);
  advance(mono_);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sound[i] += mono_[i / channels_];
  }
}

}  // namespace idiophone::voices
