#pragma once
// Stages of sheets, and what is done on them.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "sheet_map.hpp"

namespace idiophone::engines {

inline constexpr int rate = 48000, frames = 800;
inline constexpr double duration = static_cast<double>(frames) / rate;
inline const Surface steel;

inline SharedMap sheet_map() {
  return std::make_shared<const sound_maps::SoundMap>(sound_maps::sheet());
}

inline StageOptions options(double latency = 0.0) {
  return {.rate = rate, .ears = {{0.1, 0.3, 0.8}}, .latency = latency};
}

inline ContactEvent blow() {
  return {.point = {0.06, 0.03, 0.0}, .normal = {0, 0, -1}, .impulse = 0.02, .mass = 0.01, .moment = 0.25};
}

/// What follows a step of the physics.
inline std::vector<double> heard(EngineStage& stage, int steps = 1) {
  std::vector<double> sound;
  for (int i = 0; i < steps; ++i) {
    stage.step(duration);
    std::vector<double> block(frames * stage.channels());
    stage.render(block);
    sound.insert(sound.end(), block.begin(), block.end());
  }
  return sound;
}

/// The largest magnitude of a sample.
inline double peak(const std::vector<double>& sound) {
  double found = 0.0;
  for (const double pa : sound) {
    found = std::max(found, std::abs(pa));
  }
  return found;
}

/// The largest jump from one sample to the next.
inline double steepest(const std::vector<double>& sound) {
  double found = 0.0;
  for (std::size_t i = 1; i < sound.size(); ++i) {
    found = std::max(found, std::abs(sound[i] - sound[i - 1]));
  }
  return found;
}

/// Another thread that plays a stage.
class AudioThread {
 public:
  explicit AudioThread(EngineStage& stage) : thread_([this, &stage] { play(stage); }) {}
  ~AudioThread() { end(); }
  AudioThread(const AudioThread&) = delete;
  AudioThread& operator=(const AudioThread&) = delete;
  AudioThread(AudioThread&&) = delete;
  AudioThread& operator=(AudioThread&&) = delete;

  /// Waits until it has ended.
  void end() {
    ends_ = true;
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  /// Whether it has played anything but silence.
  [[nodiscard]] bool sounds() const { return sounds_; }
  /// Whether all was finite. After end().
  [[nodiscard]] bool is_finite() const { return is_finite_; }

 private:
  void play(EngineStage& stage) {
    std::vector<double> block(64);
    while (!ends_) {
      stage.render(block);
      is_finite_ = is_finite_ && std::ranges::all_of(block, [](double pa) { return std::isfinite(pa); });
      sounds_ = sounds_ || peak(block) > 0.0;
    }
  }

  std::atomic<bool> ends_ = false, sounds_ = false;
  bool is_finite_ = true;
  std::thread thread_;  // last: it uses the others
};

}  // namespace idiophone::engines
