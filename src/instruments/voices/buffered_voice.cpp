#include "idiophone/instruments/voices/buffered_voice.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>

namespace idiophone::voices {

namespace {

constexpr std::size_t most_frames = 8192;  // that are taken at once

}  // namespace

BufferedVoice::BufferedVoice(std::unique_ptr<Voice> voice, std::size_t channels, int rate, const Buffering& buffering)
    : voice_(std::move(voice)),
      channels_(channels),
      rate_(rate),
      buffering_(buffering),
      ready_(most_frames * channels) {}

std::optional<Vector3> BufferedVoice::centre(std::size_t body) const {
  const std::lock_guard lock(mutex_);
  return voice_->centre(body);
}

void BufferedVoice::require_tunable(std::size_t body, const score::Tuning& tuning) const {
  const std::lock_guard lock(mutex_);
  voice_->require_tunable(body, tuning);
}

void BufferedVoice::require_in_reach(const Vector3& place) const {
  const std::lock_guard lock(mutex_);
  voice_->require_in_reach(place);
}

void BufferedVoice::excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) {
  const std::lock_guard lock(mutex_);
  voice_->excite(body, excitation, sent);
}

void BufferedVoice::tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  const std::lock_guard lock(mutex_);
  voice_->tune(body, tuning, start);
}

void BufferedVoice::set_detail(std::size_t body, const score::Detail& detail, std::int64_t start) {
  const std::lock_guard lock(mutex_);
  voice_->set_detail(body, detail, start);
}

void BufferedVoice::set_budget(double budget, std::int64_t start) {
  const std::lock_guard lock(mutex_);
  voice_->set_budget(budget, start);
}

void BufferedVoice::hear_at(const ListenerPlace& place) {
  const std::lock_guard lock(mutex_);
  voice_->hear_at(place);
}

void BufferedVoice::attend() {
  const std::lock_guard lock(mutex_);
  voice_->attend();
}

std::int64_t BufferedVoice::lead() const {
  return voice_->lead() + static_cast<std::int64_t>(buffering_.frames * buffering_.buffers);
}

void BufferedVoice::begin() {
  voice_->begin();
  ahead_.emplace([this](std::span<double> sound) { fill(sound); }, rate_, buffering_.frames, buffering_.buffers,
                 channels_);
}

/// No exception may leave it, because nobody would catch it in its thread.
void BufferedVoice::fill(std::span<double> sound) {
  std::ranges::fill(sound, 0.0);
  if (failed_) {
    return;
  }
  try {
    const std::lock_guard lock(mutex_);
    voice_->render(sound, 0);
  } catch (const std::exception& error) {
    failed_ = true;
    spdlog::error("{}; {} is silent from now on", error.what(), voice_->bodies().front());
  }
}

VoiceReport BufferedVoice::report() const {
  return {.waits = {}, .gaps = ahead_ ? ahead_->gaps() : 0};
}

void BufferedVoice::render(std::span<double> sound, std::int64_t clock) {
  while (!sound.empty()) {
    const std::span<double> ready = std::span(ready_).first(std::min(ready_.size(), sound.size()));
    ahead_->render(ready, clock);
    for (std::size_t i = 0; i < ready.size(); ++i) {
      sound[i] += ready[i];
    }
    sound = sound.subspan(ready.size());
  }
}

}  // namespace idiophone::voices
