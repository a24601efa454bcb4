#include "idiophone/study/advice/radiation_warnings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace idiophone::advice {

namespace {

std::optional<std::string> kirchhoff_warning(const std::string& body, const mesh::Statistics& mesh, double speed) {
  const double radius = std::sqrt(mesh.surface_area / (4.0 * std::numbers::pi));
  if (2.0 * mesh.volume / mesh.surface_area >= 0.3 * radius) {
    return {};
  }
  const double frequency = speed / (2.0 * std::numbers::pi * radius);  // ka = 1
  return fmt::format(
      "body {} is thin or open: with radiation model kirchhoff its level can be wrong by 5 to 10 dB from {:.0f} to "
      "{:.0f} Hz; radiation model waves computes it, and idiophone radiate that of its modes (docs/use/radiation.md)",
      body, 0.3 * frequency, 10.0 * frequency);
}

std::optional<std::string> rayleigh_warning(const std::string& body, const mesh::Statistics& mesh) {
  if (mesh.extents[2] <= 0.1 * mesh.extents[1]) {
    return {};
  }
  return fmt::format(
      "body {} is not flat: radiation model rayleigh holds for flat surfaces in an infinite wall only; kirchhoff or "
      "idiophone radiate take its shape into account (docs/use/radiation.md)",
      body);
}

}  // namespace

std::optional<std::string> radiation_warning(const std::string& body, const mesh::Statistics& mesh,
                                             const scene::Radiation& radiation) {
  switch (radiation.model) {
    case scene::RadiationModel::huygens:
    case scene::RadiationModel::waves:
      return {};
    case scene::RadiationModel::rayleigh:
      return rayleigh_warning(body, mesh);
    case scene::RadiationModel::kirchhoff:
      return kirchhoff_warning(body, mesh, radiation.air.speed);
  }
  return {};
}

std::vector<std::string> radiation_warnings(const bodies::Preparation& ready) {
  std::vector<std::string> warnings;
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    if (const auto warning =
            radiation_warning(ready.scene.bodies[b].name, ready.statistics[b], ready.scene.radiation)) {
      warnings.push_back(*warning);
    }
  }
  return warnings;
}

}  // namespace idiophone::advice
