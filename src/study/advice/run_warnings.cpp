#include "idiophone/study/advice/run_warnings.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "idiophone/air/radiation/visibility.hpp"
#include "idiophone/study/advice/radiation_warnings.hpp"

namespace idiophone::advice {

namespace {

void add_silent_listeners(const scene::Scene& scene, std::vector<std::string>& warnings) {
  for (const auto& obstacle : scene.obstacles) {
    const radiation::HalfSpace space{obstacle.at, obstacle.direction};
    for (const auto& listener : scene.listeners) {
      for (const auto& receiver : listener.receivers) {
        if (scene.radiation.visibility && obstacle.shape == scene::Obstacle::Shape::half_space &&
            space.contains(receiver.position)) {
          warnings.push_back(fmt::format("listener {}: it is inside the obstacle {} and hears nothing",
                                         receiver.channel, obstacle.name));
        }
      }
    }
  }
}

/// @param name   as a user knows it
/// @param start  s
void add_if_too_late(const std::string& name, double start, const scene::Time& time,
                     std::vector<std::string>& warnings) {
  if (start >= time.duration) {
    warnings.push_back(
        fmt::format("{} starts at {:.6g} s and never acts, as the sound ends at {:.6g} s. Start it earlier, or raise "
                    "time.duration",
                    name, start, time.duration));
  }
}

/// @param name  of what has the signal, as a user knows it
void add_signal(const std::string& name, const scene::Signal& signal, const bodies::Preparation& ready,
                std::vector<std::string>& warnings) {
  add_if_too_late(name, signal.start, ready.scene.time, warnings);
  constexpr double least_steps = 4.0;
  const double step = ready.step();
  if (signal.shape == scene::Signal::Shape::half_sine && signal.duration < least_steps * step) {
    warnings.push_back(
        fmt::format("{} lasts {:.3g} s, which is {:.2g} steps of {:.3g} s: its impulse is wrong. Make it longer, or "
                    "raise time.steps_per_sample above {}",
                    name, signal.duration, signal.duration / step, step, ready.steps_per_sample));
  }
  if (signal.shape != scene::Signal::Shape::sine) {
    return;
  }
  const scene::Audio& audio = ready.scene.audio;
  if (signal.frequency * step > 0.5) {
    warnings.push_back(
        fmt::format("{} has {:.6g} Hz, but steps of {:.3g} s only follow up to {:.6g} Hz: the body is moved at another "
                    "frequency. Lower it, or raise time.steps_per_sample above {}",
                    name, signal.frequency, step, 0.5 / step, ready.steps_per_sample));
  } else if (signal.frequency > audio.max_frequency) {
    warnings.push_back(fmt::format(
        "{} has {:.6g} Hz, and no listener hears above {:.6g} Hz (audio.max_frequency, at most half of audio.rate)",
        name, signal.frequency, audio.max_frequency));
  }
}

}  // namespace

std::vector<std::string> run_warnings(const bodies::Preparation& ready) {
  std::vector<std::string> warnings;
  add_silent_listeners(ready.scene, warnings);
  for (const std::string& warning : radiation_warnings(ready)) {
    warnings.push_back(warning);
  }
  for (const auto& pulse : ready.scene.pulses) {
    add_signal("load " + pulse.name, pulse.signal, ready, warnings);
  }
  for (const auto& wind : ready.scene.winds) {
    add_signal("load " + wind.name, wind.signal, ready, warnings);
  }
  for (const auto& bow : ready.scene.bows) {
    add_if_too_late("load " + bow.name, bow.start, ready.scene.time, warnings);
  }
  for (const auto& body : ready.scene.bodies) {
    for (const auto& group : body.driven) {
      add_signal(fmt::format("the driven group {} of body {}", group.group, body.name), group.signal, ready, warnings);
    }
  }
  return warnings;
}

void report_doubts(const bodies::Preparation& ready) {
  for (const std::string& warning : run_warnings(ready)) {
    spdlog::warn(warning);
  }
}

}  // namespace idiophone::advice
