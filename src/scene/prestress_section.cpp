// The stress that a body has where it rests.

#include <array>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

Eigen::Matrix3d Body::initial_stress() const {
  return prestress ? Eigen::Matrix3d(turn() * prestress->stress * turn().transpose()) : Eigen::Matrix3d::Zero();
}

/// {xx, yy, zz, yz, xz, xy}
static bool read(const Node& node, Mistakes& mistakes, Prestress& prestress) {
  constexpr std::array keys = {"xx", "yy", "zz", "yz", "xz", "xy"};
  prestress.where = node.where;
  Section section(node, mistakes);
  for (const std::string key : keys) {
    double& component = prestress.stress(key[0] - 'x', key[1] - 'x');
    section.optional(key, component, Range{.at_least = -1e12, .at_most = 1e12, .unit = "Pa"});
    prestress.stress(key[1] - 'x', key[0] - 'x') = component;
  }
  const bool good = section.finish();
  if (good && prestress.stress.isZero(0.0)) {
    return mistakes.add(node, "needs a stress other than 0 Pa: xx, yy, zz, yz, xz or xy; leave it out for none");
  }
  return good;
}

void read_prestress(Section& section, Body& body) {
  if (section.find("prestress") == nullptr) {
    return;
  }
  if (!body.fracture.empty()) {
    section.refuse("prestress", "has no meaning with fracture: what breaks would no longer be held under its stress");
  } else if (body.mass_scaling) {
    section.refuse("prestress", "has no meaning with mass_scaling: its longer steps hold for bodies without stress");
  } else {
    section.optional("prestress", body.prestress);
  }
}

}  // namespace idiophone::scene
