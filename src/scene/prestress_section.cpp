// What strains a body before it vibrates: a stress, a change of temperature, a group held away from its place.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "idiophone/scene/large_amplitudes.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

Eigen::Matrix3d Body::initial_stress() const {
  return prestress ? Eigen::Matrix3d(turn() * prestress->stress * turn().transpose()) : Eigen::Matrix3d::Zero();
}

/// {group, displacement}
static bool read(const Node& node, Mistakes& mistakes, StretchedGroup& stretch) {
  Section section(node, mistakes);
  section.required("group", stretch.group);
  section.required("displacement", stretch.displacement, coordinate);
  return section.finish();
}

/// {xx, yy, zz, yz, xz, xy, temperature, stretch}
static bool read(const Node& node, Mistakes& mistakes, Prestress& prestress) {
  constexpr std::array keys = {"xx", "yy", "zz", "yz", "xz", "xy"};
  prestress.where = node.where;
  Section section(node, mistakes);
  for (const std::string key : keys) {
    double& component = prestress.stress(key[0] - 'x', key[1] - 'x');
    section.optional(key, component, Range{.at_least = -1e12, .at_most = 1e12, .unit = "Pa"});
    prestress.stress(key[1] - 'x', key[0] - 'x') = component;
  }
  section.optional("temperature", prestress.temperature, Range{.at_least = -1e4, .at_most = 1e4, .unit = "K"});
  section.optional("stretch", prestress.stretch);
  const bool good = section.finish();
  if (good && prestress.stress.isZero(0.0) && prestress.temperature == 0.0 && !prestress.stretch) {
    return mistakes.add(node,
                        "needs a stress other than 0 Pa (xx, yy, zz, yz, xz or xy), a change of temperature or a "
                        "stretch; leave it out for none");
  }
  return good;
}

namespace {

/// Whether the group is fixed along all axes along which it is displaced.
bool holds(const Body& body, const StretchedGroup& stretch) {
  return std::ranges::any_of(body.fixed, [&](const FixedGroup& fixed) {
    const auto is_held = [&](int axis) { return fixed.axes[axis] || stretch.displacement[axis] == 0.0; };
    return fixed.group == stretch.group && !fixed.hinge && is_held(0) && is_held(1) && is_held(2);
  });
}

void check_prestress(Section& section, const Body& body, const std::vector<Material>& materials) {
  const Prestress& prestress = *body.prestress;
  if (prestress.stretch && !holds(body, *prestress.stretch)) {
    section.refuse("prestress",
                   fmt::format("stretches the group '{}', which needs to be in `fixed`, held along the axes "
                               "of the displacement",
                               prestress.stretch->group));
  }
  for (const MaterialRegion& region : body.all_regions()) {
    const Material& material = materials.at(region.material);
    if (prestress.temperature != 0.0 && !material.expansion) {
      section.refuse("prestress", fmt::format("changes the temperature, and the material '{}' has no `expansion`, 1/K",
                                              material.name));
      return;
    }
  }
  if (has_large_amplitudes(body) && (prestress.stretch || prestress.temperature != 0.0)) {
    section.refuse("prestress",
                   "has a stretch or a temperature, which large_amplitudes can't have yet: give the stress "
                   "that results, such as xx, or use finite elements");
  }
}

}  // namespace

void read_prestress(Section& section, Body& body, const std::vector<Material>& materials) {
  if (section.find("prestress") == nullptr) {
    return;
  }
  if (!body.fracture.empty()) {
    section.refuse("prestress", "has no meaning with fracture: what breaks would no longer be held under its stress");
  } else if (body.mass_scaling) {
    section.refuse("prestress", "has no meaning with mass_scaling: its longer steps hold for bodies without stress");
  } else if (section.optional("prestress", body.prestress) && body.prestress && !materials.empty()) {
    check_prestress(section, body, materials);
  }
}

}  // namespace idiophone::scene
