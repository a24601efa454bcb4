#include <algorithm>

#include "ranges.hpp"
#include "sections.hpp"

namespace idiophone::scene {

/// Some of the letters x, y and z.
static bool read(const Node& node, Mistakes& mistakes, Axes& axes) {
  Axes found{};
  bool good = node.kind == Node::Kind::scalar && !node.text.empty();
  for (const char letter : node.text) {
    const std::size_t axis = std::string_view("xyz").find(letter);
    good = good && axis < found.size() && !found.at(axis);
    if (good) {
      found.at(axis) = true;
    }
  }
  if (!good) {
    return mistakes.add(node, "expected some of the letters xyz, each once, e.g. xz; found " + describe(node));
  }
  axes = found;
  return true;
}

/// GROUP, or {group: GROUP, axes: xz}
static bool read(const Node& node, Mistakes& mistakes, FixedGroup& fixed) {
  fixed.where = node.where;
  if (node.kind != Node::Kind::map) {
    return read(node, mistakes, fixed.group);
  }
  Section section(node, mistakes);
  section.required("group", fixed.group);
  section.optional("axes", fixed.axes);
  return section.finish();
}

static bool read(const Node& node, Mistakes& mistakes, DrivenGroup& driven, const Folder& folder) {
  driven.where = node.where;
  Section section(node, mistakes);
  section.required("group", driven.group);
  const bool axes_known = section.optional("axes", driven.axes);
  if (section.required("displacement", driven.displacement, coordinate) && axes_known) {
    if (driven.displacement.isZero(0.0)) {
      mistakes.add(*section.find("displacement"), "is zero; a group that is held still belongs under fixed");
    }
    for (int i = 0; i < 3; ++i) {
      if (driven.axes.at(i) || driven.displacement[i] == 0.0) {
        continue;
      }
      mistakes.add(section.find("displacement")->children[i], "must be 0, for axes leaves this direction free");
    }
  }
  read_signal(section, folder, driven.signal);
  return section.finish();
}

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

static void read_mesh(Section& section, Body& body, const Folder& folder) {
  const Node* mesh = section.find("mesh");
  if (!section.required("mesh", body.mesh, folder)) {
    return;
  }
  body.mesh_where = mesh->where;
  constexpr std::array known = {".geo", ".msh", ".step", ".brep", ".stl"};
  if (std::ranges::find(known, body.mesh.extension()) == known.end()) {
    section.mistakes().add(*mesh, fmt::format("must end in {}, found {}", fmt::join(known, ", "), describe(*mesh)));
  }
}

static void read_parameters(const Node& node, Mistakes& mistakes, Body& body) {
  if (node.kind != Node::Kind::map) {
    mistakes.add(node, "expected a map of numbers, found " + describe(node));
    return;
  }
  if (!body.mesh.empty() && body.mesh.extension() != ".geo") {
    mistakes.add(node.key_where, node.path + ": only a .geo mesh has parameters; leave them out");
  }
  for (const Node& parameter : node.children) {
    read(parameter, mistakes, body.parameters[parameter.key], Range{});
    body.parameters_where[parameter.key] = parameter.key_where;
  }
}

/// A direction of a group can only be held once.
static void refuse_overlaps(const Body& body, Mistakes& mistakes) {
  std::map<std::string, Axes> held;
  const auto hold = [&](const std::string& group, const Axes& axes, const Location& where) {
    Axes& already = held[group];
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes.at(i) && already.at(i)) {
        mistakes.add(where, fmt::format("bodies.{}: {} of the group '{}' is fixed or driven more than once", body.name,
                                        "xyz"[i], group));
      }
      already.at(i) = already.at(i) || axes.at(i);
    }
  };
  for (const FixedGroup& fixed : body.fixed) {
    hold(fixed.group, fixed.axes, fixed.where);
  }
  for (const DrivenGroup& driven : body.driven) {
    hold(driven.group, driven.axes, driven.where);
  }
}

bool read(const Node& node, Mistakes& mistakes, Body& body, const Scene& so_far) {
  const Choices<ElementType> elements{{{"tet4", ElementType::tet4}, {"tet10", ElementType::tet10}}};
  const Folder folder{so_far.deck.parent_path()};
  body.where = node.key_where;
  Section section(node, mistakes);
  read_mesh(section, body, folder);
  if (const Node* parameters = section.find("parameters")) {
    read_parameters(*parameters, mistakes, body);
  }
  section.optional("element", body.element, elements);
  section.required("material", body.material, names_of(so_far.materials));
  const bool fixed_good = section.optional("fixed", body.fixed);
  const bool driven_good = section.optional("driven", body.driven, folder);
  if (fixed_good && driven_good) {
    refuse_overlaps(body, mistakes);
  }
  section.optional("supports", body.supports);
  section.optional("velocity", body.velocity, Range{.at_least = -1e5, .at_most = 1e5, .unit = "m/s"});
  section.optional("spin", body.spin, Range{.at_least = -1e6, .at_most = 1e6, .unit = "rad/s"});
  return section.finish();
}

}  // namespace idiophone::scene
