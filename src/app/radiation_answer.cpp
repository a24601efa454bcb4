#include "radiation_answer.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "answer.hpp"
#include "idiophone/air/harmonic/radiation_file.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "listener_warnings.hpp"

namespace idiophone::app {

namespace {

void print_radiation(const harmonic::Radiation& result) {
  fmt::print("body {}: {} vertices, {} triangles\n", result.body, result.surfaces.front().vertices.size(),
             result.surfaces.front().triangles.size());
  fmt::print("{:<10}  {:>12}  {:>11}  {:>8}  {:>10}  {:>11}  {:>14}  {:>13}  {:>9}\n", "motion", "frequency/Hz",
             "power/W", "error/dB", "efficiency", "loss factor", "directivity/dB", "kirchhoff/dB", "waves/dB");
  for (const auto& sound : result.sounds) {
    fmt::print("{:<10}  {:>12.2f}  {:>11.4g}  {:>8}  {:>10.4g}  {:>11}  {:>14.1f}  {:>+13.1f}  {:>9}\n", sound.name,
               sound.frequency, sound.power,
               std::isnan(sound.level_error) ? "-" : fmt::format("{:.2f}", sound.level_error), sound.efficiency,
               std::isnan(sound.loss_factor) ? "-" : fmt::format("{:.4g}", sound.loss_factor), sound.directivity_index,
               sound.kirchhoff_error, std::isnan(sound.waves_error) ? "-" : fmt::format("{:+.2f}", sound.waves_error));
  }
  fmt::print(
      "(error: of the power, as the last refinement of the surface changes it; kirchhoff, waves: power by these "
      "radiation "
      "models, above this one)\n");
}

nlohmann::json radiation_facts(const harmonic::Radiation& result) {
  nlohmann::json answer = {{"body", result.body},
                           {"vertices", result.surfaces.front().vertices.size()},
                           {"triangles", result.surfaces.front().triangles.size()},
                           {"sounds", nlohmann::json::array()}};
  for (const auto& sound : result.sounds) {
    auto listeners = nlohmann::json::object();
    for (std::size_t l = 0; l < result.listener_names.size(); ++l) {
      listeners[result.listener_names[l]] = {sound.listener_pressure[l].real(), sound.listener_pressure[l].imag()};
    }
    answer["sounds"].push_back({{"motion", sound.name},
                                {"frequency", sound.frequency},
                                {"power", sound.power},
                                {"mean_square_velocity", sound.mean_square_velocity},
                                {"level_error", loop::number_or_null(sound.level_error)},
                                {"solved_vertices", sound.solution.pressure.size()},
                                {"efficiency", sound.efficiency},
                                {"loss_factor", loop::number_or_null(sound.loss_factor)},
                                {"directivity_index", sound.directivity_index},
                                {"kirchhoff_error", sound.kirchhoff_error},
                                {"kirchhoff_worst", sound.kirchhoff_worst},
                                {"rayleigh_error", sound.rayleigh_error},
                                {"rayleigh_worst", sound.rayleigh_worst},
                                {"waves_error", loop::number_or_null(sound.waves_error)},
                                {"waves_worst", loop::number_or_null(sound.waves_worst)},
                                {"listeners", listeners}});
  }
  return answer;
}

}  // namespace

std::string radiation_name(const std::string& name, std::size_t bodies, const std::string& body) {
  return name + (bodies > 1 ? "_" + body : "") + "_radiation";
}

void warn_of_unheard(const scene::Scene& scene) {
  if (scene.radiation.room) {
    spdlog::warn("the walls of radiation.room are left out; radiation: {{floor: ...}} reflects sound");
  }
  warn_of_still_listeners(scene, "the result");
}

void write_and_print(const std::filesystem::path& path, const Origin& origin, const harmonic::Radiation& result,
                     Style style) {
  harmonic::write_radiation(path, origin, result);
  if (style == Style::json) {
    print_answer(radiation_facts(result));
  } else {
    print_radiation(result);
  }
}

}  // namespace idiophone::app
