#include "sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Damping& damping) {
  Section section(node, mistakes);
  section.optional("mass", damping.mass, Range{.at_least = 0.0, .at_most = 1e9, .unit = "1/s"});
  section.optional("stiffness", damping.stiffness, Range{.at_least = 0.0, .at_most = 1e3, .unit = "s"});
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, Material& material) {
  material.where = node.key_where;
  Section section(node, mistakes);
  section.required("young", material.young, Range{.above = 0.0, .at_most = 1e15, .unit = "Pa"});
  section.required("poisson", material.poisson, Range{.above = -1.0, .below = 0.5});
  section.required("density", material.density, Range{.above = 0.0, .at_most = 1e6, .unit = "kg/m3"});
  section.optional("damping", material.damping);
  return section.finish();
}

}  // namespace idiophone::scene
