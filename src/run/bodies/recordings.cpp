// The recordings that a deck names.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <functional>
#include <stdexcept>
#include <string_view>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/recorded_source.hpp"
#include "idiophone/run/results/verification.hpp"

namespace idiophone::bodies {

namespace {

/// What is wrong with a recording; empty for nothing.
std::string problem(const surface::RecordingHeader& header, const scene::Scene& scene) {
  const auto& air = scene.radiation.air;
  if (header.rate != scene.audio.rate) {
    return fmt::format("it has {:.0f} audio samples per second, audio.rate is {}", header.rate, scene.audio.rate);
  }
  if (header.air_density != air.density || header.air_speed != air.speed) {
    return fmt::format("its air has {:.6g} kg/m3 and {:.6g} m/s, radiation.air has {:.6g} kg/m3 and {:.6g} m/s",
                       header.air_density, header.air_speed, air.density, air.speed);
  }
  return "";
}

}  // namespace

void check_recordings(const scene::Scene& scene) {
  for (const scene::RecordedBody& body : scene.recorded_bodies) {
    const std::string key = "bodies." + body.name + ".recording: ";
    try {
      results::require_intact(body.recording);
      const results::SurfaceMotionReader reader(body.recording);
      if (const std::string what = problem(reader.header(), scene); !what.empty()) {
        throw std::runtime_error(what);
      }
      const std::int64_t end = reader.rows() - 1 + reader.header().first_sample;
      if (end < sound_samples(scene)) {
        spdlog::warn("body {}: its recording ends at {:.6g} s; it stays still from there on", body.name,
                     static_cast<double>(end) / scene.audio.rate);
      }
    } catch (const std::runtime_error& error) {
      throw deck::DeckError(body.where, key + error.what());
    }
  }
}

std::string fingerprint(const scene::Scene& scene) {
  std::string text;
  for (const scene::RecordedBody& body : scene.recorded_bodies) {
    const results::SurfaceMotionReader reader(body.recording);
    std::size_t hash = 0;
    for (const std::int64_t row : {reader.rows() / 2, reader.rows() - 1}) {
      const std::vector<double> values = reader.read_pressure(row, 1, 0, reader.triangles());
      const auto* bytes = reinterpret_cast<const char*>(values.data());
      hash = 31 * hash + std::hash<std::string_view>()({bytes, sizeof(double) * values.size()});
    }
    text += fmt::format("+{}:{}x{}:{:016x}", body.name, reader.rows(), reader.triangles(), hash);
  }
  return text;
}

}  // namespace idiophone::bodies
