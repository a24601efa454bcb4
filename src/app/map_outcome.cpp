#include "map_outcome.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "answer.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "search_watch.hpp"

namespace idiophone::app {

namespace {

nlohmann::json map_facts(const sound_maps::SoundMap& map, const std::filesystem::path& path) {
  auto errors = nlohmann::json::array();
  std::ranges::transform(map.mesh_error, std::back_inserter(errors), loop::number_or_null);
  return {{"file", path.string()},
          {"body", map.body},
          {"modes", map.modes()},
          {"lowest_frequency", map.frequency.front()},
          {"highest_frequency", map.frequency.back()},
          {"frequencies", map.frequency},
          {"mesh_errors", errors},
          {"vertices", map.vertices.size()},
          {"triangles", map.triangles.size()},
          {"listeners", map.listeners.size()},
          {"directions", map.sphere.direction.size()},
          {"stretching_terms", map.stretching.terms()},
          {"radiation", map.radiation}};
}

void print_map(const sound_maps::SoundMap& map, const std::filesystem::path& path) {
  spdlog::info("{}: body {}, {} modes from {:.6g} to {:.6g} Hz, {} vertices, {} triangles, {} listeners, {} directions",
               path.string(), map.body, map.modes(), map.frequency.front(), map.frequency.back(), map.vertices.size(),
               map.triangles.size(), map.listeners.size(), map.sphere.direction.size());
  if (map.stretching.exists()) {
    const auto all = map.stretching.quadratic.size();
    const auto zero = static_cast<std::size_t>(std::ranges::count(map.stretching.quadratic, 0.0));
    spdlog::info("body {}: large amplitudes, {} terms of stretching; {} of {} numbers for pairs of modes are not zero",
                 map.body, map.stretching.terms(), all - zero, all);
  }
  if (const std::string errors = sound_maps::mesh_error_text(map); !errors.empty()) {
    spdlog::info("body {}: {}", map.body, errors);
  }
}

}  // namespace

void write_map(const std::filesystem::path& path, const sound_maps::SoundMap& map, Style style, MapOutcome& outcome) {
  sound_maps::write_sound_map(path, map);
  outcome.maps.push_back(map_facts(map, path));
  if (style == Style::text) {
    print_map(map, path);
  }
}

int report_maps(const MapOutcome& outcome, Style style) {
  if (style == Style::json) {
    print_answer(
        nlohmann::json{{"maps", outcome.maps}, {"without_modes", outcome.failures}, {"stopped", outcome.stopped}});
  }
  if (!outcome.stopped.empty()) {
    say_left_out(outcome.stopped);
    return loop::exit_resumable;
  }
  if (outcome.failures.empty()) {
    return loop::exit_finished;
  }
  std::string reasons;
  for (const auto& failure : outcome.failures) {
    reasons += "; " + failure["reason"].get<std::string>();
  }
  fmt::print(stderr, "idiophone: {} of {} bodies have no map{}\n", outcome.failures.size(),
             outcome.failures.size() + outcome.maps.size(), reasons);
  return loop::exit_failed;
}

}  // namespace idiophone::app
