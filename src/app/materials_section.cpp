#include "materials_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "idiophone/scene/symmetries.hpp"

namespace idiophone::app {

namespace {

std::string damping_text(const scene::Damping& damping) {
  std::vector<std::string> entries;
  if (damping.mass > 0) {
    entries.push_back(fmt::format("mass: {:.4g}", damping.mass));
  }
  if (damping.stiffness > 0) {
    entries.push_back(fmt::format("stiffness: {:.4g}", damping.stiffness));
  }
  if (damping.loss) {
    const auto& [lowest, highest] = damping.loss->band;
    entries.push_back(fmt::format("loss_factor: {:.4g}, band: [{:.4g}, {:.4g}]", damping.loss->value, lowest, highest));
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
  const auto list = [](const Vector3& values) {
    return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", values[0], values[1], values[2]);
  };
  if (const auto& constants = material.orthotropy) {
    text += fmt::format("    young: {}\n    poisson: {}\n    shear: {}\n", list(constants->young),
                        list(constants->poisson), list(constants->shear));
  } else if (material.crystal) {
    text += fmt::format("    stiffness: {}\n", stiffness_text(*material.crystal));
  } else {
    text += fmt::format("    young: {:.6g}\n    poisson: {:.5g}\n", material.young, material.poisson);
  }
  return text + fmt::format("    density: {:.6g}\n    damping: {}\n", material.density, damping_text(material.damping));
}

}  // namespace idiophone::app
