#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include "idiophone/instruments/outputs/audio_output.hpp"

namespace idiophone::outputs {

DeviceOutput::DeviceOutput(AudioOptions options, std::string what, int rate)
    : options_(std::move(options)), what_(std::move(what)), rate_(rate) {}

std::int64_t DeviceOutput::horizon() const {
  constexpr double ahead = 0.2;  // s by which a score is known
  return std::llround(ahead * rate_);
}

void DeviceOutput::start(Renderer& renderer) {
  audio_.emplace(renderer, options_);
  spdlog::info("{}: {}, {} channels, {} Hz, latency {:.3g} ms; Ctrl-C ends", audio_->device(), what_,
               renderer.receivers(), rate_, 1e3 * audio_->report().output_latency);
}

bool DeviceOutput::advance() {
  constexpr auto pause = std::chrono::microseconds(200);
  std::this_thread::sleep_for(pause);
  return audio_->report().running;
}

void DeviceOutput::finish() {
  const AudioReport report = audio_->report();
  spdlog::info("{} blocks of {} frames; load {:.3g} %, largest {:.3g} %; {} late blocks", report.blocks,
               options_.frames, 100.0 * report.mean_load, 100.0 * report.largest_load, report.late);
  if (report.clipped > 0) {
    spdlog::warn("{} samples exceed full scale and were clipped; raise --full-scale", report.clipped);
  }
  if (!report.running) {
    throw std::runtime_error(audio_->device() + ": the device or its server stopped");
  }
}

}  // namespace idiophone::outputs
