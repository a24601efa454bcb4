#include "materials_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "idiophone/scene/symmetries.hpp"

namespace idiophone::app {

namespace {

std::string list(const Vector3& values, int digits) {
  return fmt::format("[{0:.{3}g}, {1:.{3}g}, {2:.{3}g}]", values[0], values[1], values[2], digits);
}

/// The keys of a loss factor; a curve has its band by itself.
std::string loss_text(const scene::LossFactor& loss) {
  if (!loss.curve.empty()) {
    std::vector<std::string> points;
    for (const auto& [frequency, value] : loss.curve) {
      points.push_back(fmt::format("[{:.4g}, {:.4g}]", frequency, value));
    }
    return fmt::format("loss_factor: [{}]", fmt::join(points, ", "));
  }
  const std::string value = loss.directions ? fmt::format("{{young: {}, shear: {}}}", list(loss.directions->young, 4),
                                                          list(loss.directions->shear, 4))
                                            : fmt::format("{:.4g}", loss.value);
  return fmt::format("loss_factor: {}, band: [{:.4g}, {:.4g}]", value, loss.band[0], loss.band[1]);
}

std::string damping_text(const scene::Damping& damping) {
  std::vector<std::string> entries;
  if (damping.mass > 0) {
    entries.push_back(fmt::format("mass: {:.4g}", damping.mass));
  }
  if (damping.stiffness > 0) {
    entries.push_back(fmt::format("stiffness: {:.4g}", damping.stiffness));
  }
  if (damping.loss) {
    entries.push_back(loss_text(*damping.loss));
  }
  return fmt::format("{{{}}}", fmt::join(entries, ", "));
}

std::string stiffness_text(const scene::Crystal& crystal) {
  std::string text = fmt::format("symmetry: {}", deck::to_node(crystal.symmetry, scene::symmetries()).text);
  const auto each = scene::independent_constants(crystal.symmetry);
  for (std::size_t k = 0; k < each.size(); ++k) {
    if (!each[k].is_optional || crystal.constants[k] != 0) {
      text += fmt::format(", {}: {:.6g}", each[k].name, crystal.constants[k]);
    }
  }
  return fmt::format("{{{}}}", text);
}

}  // namespace

std::string materials_section(const scene::Material& material) {
  std::string text = fmt::format("materials:\n  {}:\n", material.name);
  if (const auto& constants = material.orthotropy) {
    text += fmt::format("    young: {}\n    poisson: {}\n    shear: {}\n", list(constants->young, 6),
                        list(constants->poisson, 6), list(constants->shear, 6));
  } else if (material.crystal) {
    text += fmt::format("    stiffness: {}\n", stiffness_text(*material.crystal));
  } else {
    text += fmt::format("    young: {:.6g}\n    poisson: {:.5g}\n", material.young, material.poisson);
  }
  return text + fmt::format("    density: {:.6g}\n    damping: {}\n", material.density, damping_text(material.damping));
}

}  // namespace idiophone::app
