#include "mesh_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "idiophone/run/loop/facts.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/solids/accuracy/recommendation.hpp"
#include "idiophone/solids/solid/mass_scaling.hpp"
#include "idiophone/study/advice/recommendations.hpp"

namespace idiophone::app {

namespace {

void report(const advice::PitchEstimate& estimate, const std::string& body) {
  std::vector<std::string> modes;
  for (std::size_t mode = 0; mode < estimate.frequencies.size(); ++mode) {
    modes.push_back(fmt::format("{:.5g} Hz {:+.1f} cents", estimate.frequencies[mode], estimate.mesh_errors[mode]));
  }
  spdlog::info("body {}: its lowest modes, and how much the mesh makes each too high, as estimated: {}", body,
               fmt::join(modes, ", "));
}

}  // namespace

void report_mesh(const bodies::Preparation& ready) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    const auto& mesh = ready.statistics[b];
    spdlog::info(
        "body {}: edges {:.4g} to {:.4g} m, volume {:.6g} m3; worst element {} at ({:.4g}, {:.4g}, {:.4g}), quality "
        "{:.3f}",
        ready.scene.bodies[b].name, mesh.smallest_edge, mesh.largest_edge, mesh.volume, mesh.worst_element,
        mesh.worst_centre[0], mesh.worst_centre[1], mesh.worst_centre[2], mesh.worst_quality);
  }
}

std::optional<std::string> pitch_warning(const bodies::Preparation& ready, std::size_t b) {
  const auto& body = ready.scene.bodies[b];
  if (!ready.initial_state.steps[b].is_limited() || !body.is_one_material_at_rest()) {
    return {};
  }
  // Curved thin walls have no rules for their pitch, but they lock and need as many elements in a wave as flat ones.
  return accuracy::mesh_warning(ready.statistics[b], body, ready.scene.materials[body.material],
                                std::min(ready.scene.audio.max_frequency, solid::highest_audible));
}

std::vector<std::optional<advice::PitchEstimate>> pitch_estimates(const bodies::Preparation& ready,
                                                                  const std::vector<mesh::Mesh>& meshes) {
  std::vector<std::optional<advice::PitchEstimate>> all(ready.scene.bodies.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const bool is_whole = meshes[b].element_count() > 0;
    if (is_whole && ready.initial_state.steps[b].is_limited() && !scene::is_joined(b, ready.scene.joints)) {
      all[b] = advice::pitch_estimate(ready.scene, b, meshes[b]);
    }
  }
  return all;
}

void report_pitch(const bodies::Preparation& ready,
                  const std::vector<std::optional<advice::PitchEstimate>>& estimates) {
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    if (estimates[b]) {
      report(*estimates[b], ready.scene.bodies[b].name);
    } else if (const auto limits = loop::pitch_limits(ready, b)) {
      spdlog::info(
          "body {}: pitch within about 5 cents up to {:.0f} Hz, 50 cents up to {:.0f} Hz, by the rules for even cells; "
          "`idiophone modes` estimates the error of each mode",
          ready.scene.bodies[b].name, limits->first, limits->second);
    } else if (const auto kind = accuracy::without_rules(ready.scene.bodies[b], ready.statistics[b])) {
      spdlog::info("body {}: there is no rule for the pitch of {}; `idiophone modes` estimates the error of each mode",
                   ready.scene.bodies[b].name, *kind);
    }
    if (const auto warning = pitch_warning(ready, b)) {
      spdlog::warn(*warning);
    }
  }
}

std::vector<advice::CrossSection> sections_of(const scene::Scene& scene, const std::vector<mesh::Mesh>& meshes) {
  std::vector<advice::CrossSection> sections;
  for (std::size_t b = 0; scene.radiation.model == scene::RadiationModel::waves && b < meshes.size(); ++b) {
    sections.push_back(advice::smallest_cross_section(meshes[b].outer_surface(), meshes[b].nodes));
  }
  return sections;
}

void report_sections(const std::vector<advice::CrossSection>& sections, const scene::Scene& scene) {
  const double cell = scene.radiation.grid.cell;
  for (std::size_t b = 0; b < sections.size(); ++b) {
    const auto& section = sections[b];
    const double error = advice::level_error(section, cell);
    const bool is_fine = error <= advice::small_level_error;
    spdlog::log(is_fine ? spdlog::level::info : spdlog::level::warn,
                "body {}: {:.1f} cells across its thinnest part ({:.3g} m); its level is off by up to {:.1f} dB{}",
                scene.bodies[b].name, section.thickness / cell, section.thickness, error,
                is_fine ? "" : fmt::format("; radiation.cell: {:.2g} gives 0.5 dB", advice::fine_cell(section)));
    spdlog::info(
        "  parts that move against each other, as the tines of a fork, can be off by more than 3 dB below {:.0f} Hz",
        advice::opposite_parts_from(section, cell, scene.radiation.air.speed));
  }
}

}  // namespace idiophone::app
