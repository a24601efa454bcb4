#include "ranges.hpp"
#include "sections.hpp"

namespace idiophone::scene {

static bool read(const Node& node, Mistakes& mistakes, Support& support) {
  Section section(node, mistakes);
  read_place(section, support.place);
  section.optional("stiffness", support.stiffness, Range{.at_least = 0.0, .at_most = 1e15, .unit = "N/m"});
  section.optional("damping", support.damping, Range{.at_least = 0.0, .at_most = 1e12, .unit = "N s/m"});
  const bool good = section.finish();
  if (good && support.stiffness == 0.0 && support.damping == 0.0) {
    return mistakes.add(node, "a support needs a stiffness (N/m) or a damping (N s/m) above 0");
  }
  return good;
}

bool read(const Node& node, Mistakes& mistakes, Body& body, const Scene& so_far) {
  const Choices<ElementType> elements{{{"tet4", ElementType::tet4}, {"tet10", ElementType::tet10}}};
  const Folder folder{so_far.deck.parent_path()};
  body.where = node.key_where;
  Section section(node, mistakes);
  read_mesh(section, body, folder);
  section.optional("rotation", body.rotation, turn);
  section.optional("position", body.position, coordinate);
  section.optional("element", body.element, elements);
  section.required("material", body.material, names_of(so_far.materials));
  read_constraints(section, body, folder);
  section.optional("supports", body.supports);
  section.optional("velocity", body.velocity, Range{.at_least = -1e5, .at_most = 1e5, .unit = "m/s"});
  section.optional("spin", body.spin, Range{.at_least = -1e6, .at_most = 1e6, .unit = "rad/s"});
  return section.finish();
}

}  // namespace idiophone::scene
