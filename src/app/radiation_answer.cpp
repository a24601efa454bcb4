#include "radiation_answer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "idiophone/run/loop/facts.hpp"

namespace idiophone::app {

void print_radiation(const harmonic::Radiation& result) {
  fmt::print("body {}: {} vertices, {} triangles\n", result.body, result.vertices.size(), result.triangles.size());
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
                           {"vertices", result.vertices.size()},
                           {"triangles", result.triangles.size()},
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
                                {"solved_vertices", std::lround(sound.solved_vertices)},
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

}  // namespace idiophone::app
