#include "proxies_live.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

#include "idiophone/instruments/drivers/osc.hpp"
#include "idiophone/instruments/drivers/proxy_events.hpp"
#include "idiophone/instruments/outputs/audio_output.hpp"
#include "idiophone/instruments/outputs/buffered_renderer.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::app {

void play_proxies(proxies::Engine& engine, const score::Score& score, const std::vector<std::string>& names, int rate,
                  const LiveProxies& options) {
  constexpr auto pause = std::chrono::milliseconds(1);
  std::mutex mutex;  // of the engine; the audio thread does not touch it
  outputs::BufferedRenderer renderer(
      [&](std::span<double> sound) {
        const std::lock_guard lock(mutex);
        engine.render(sound);
      },
      rate, static_cast<std::size_t>(options.frames), static_cast<std::size_t>(options.buffers));
  const auto play = [&](const score::ScoreEvent& event) {
    const std::lock_guard lock(mutex);
    drivers::add_event(event, engine.now(), score.seed, rate, engine);
  };
  const auto move_listener = [&](const Vector3& place) {
    const std::lock_guard lock(mutex);
    for (std::size_t body = 0; body < names.size(); ++body) {
      engine.move_listener(body, place);
    }
  };
  if (score.listener && score.listener->path) {
    spdlog::warn("the listener stays where it is at time 0; /listener moves it");
  }
  std::optional<drivers::OscServer> osc;
  if (options.osc) {
    osc.emplace(*options.osc, names, drivers::OscActions{.play = play, .move_listener = move_listener});
  }
  const outputs::AudioOutput audio(
      renderer,
      {.device = options.device, .frames = static_cast<std::size_t>(options.frames), .full_scale = options.full_scale});
  spdlog::info("{}: {} bodies, {} buffers of {} frames; Ctrl-C ends", audio.device(), names.size(), options.buffers,
               options.frames);
  const std::int64_t end = std::llround(score.duration * rate);
  loop::watch_signals(loop::OnSignal::note);
  while (loop::noted_signal() == 0 && (osc || renderer.now() < end) && audio.report().running) {
    if (osc) {
      osc->poll();
    }
    std::this_thread::sleep_for(pause);
  }
  const outputs::AudioReport report = audio.report();
  spdlog::info("{:.4g} s; {} gaps", static_cast<double>(renderer.now()) / rate, renderer.gaps());
  if (report.clipped > 0) {
    spdlog::warn("{} samples exceed full scale and were clipped; raise --full-scale", report.clipped);
  }
  if (!report.running) {
    throw std::runtime_error(audio.device() + ": the device or its server stopped");
  }
}

}  // namespace idiophone::app
