// Groups of a body that are held or moved.

#include "face_groups.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// A group about whose line the body is free to turn.
struct Hinge {
  std::string group;
  Location where;
};

bool read(const Node& node, Mistakes& mistakes, Axes& axes, const AxisLetters& /*rule*/) {
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

Node to_node(const Axes& axes, const AxisLetters& /*rule*/) {
  std::string letters;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    letters += axes.at(i) ? std::string(1, "xyz"[i]) : "";
  }
  return deck::scalar(letters);
}

/// GROUP, or {group: GROUP, axes: xz}
static bool read(const Node& node, Mistakes& mistakes, FixedGroup& fixed) {
  fixed.where = node.where;
  if (node.kind != Node::Kind::map) {
    return read(node, mistakes, fixed.group);
  }
  Section section(node, mistakes);
  section.required("group", fixed.group);
  section.optional("axes", fixed.axes, axis_letters);
  return section.finish();
}

static bool read(const Node& node, Mistakes& mistakes, Hinge& hinge) {
  hinge.where = node.where;
  return read(node, mistakes, hinge.group);
}

namespace {

/// {axis, degrees, pivot}
void read_rotation(const Node& node, Mistakes& mistakes, DrivenGroup& driven) {
  Section section(node, mistakes);
  read_turn(section, driven.rotation);
  section.required("pivot", driven.pivot, coordinate);
  section.finish();
}

/// The motion must be one that the held axes can follow, and none at all belongs under fixed.
void check_motion(Section& section, const DrivenGroup& driven) {
  const Node* axes = section.find("axes");
  const Node* displacement = section.find("displacement");
  if (!driven.moves()) {
    section.mistakes().add(
        displacement != nullptr ? *displacement : section.node(),
        "needs a displacement (m) or a rotation that is not zero; a group that is held still belongs "
        "under fixed");
  }
  for (std::size_t i = 0; i < driven.axes.size(); ++i) {
    if (!driven.axes.at(i) && section.find("rotation") != nullptr) {
      section.mistakes().add(*axes, "must be xyz, or left out: a group that turns is held in all directions");
      return;
    }
    if (!driven.axes.at(i) && driven.displacement[i] != 0.0) {
      section.mistakes().add(section.find("displacement")->children[i],
                             "must be 0, for axes leaves this direction free");
    }
  }
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, DrivenGroup& driven, const Folder& folder) {
  driven.where = node.where;
  Section section(node, mistakes);
  const std::size_t before = mistakes.count();
  section.required("group", driven.group);
  section.optional("axes", driven.axes, axis_letters);
  section.optional("displacement", driven.displacement, coordinate);
  if (const Node* rotation = section.find("rotation")) {
    read_rotation(*rotation, mistakes, driven);
  }
  if (mistakes.count() == before) {
    check_motion(section, driven);
  }
  read_signal(section, folder, driven.signal);
  return section.finish();
}

namespace {

/// A direction of a group can only be held once.
void refuse_overlaps(const Body& body, Mistakes& mistakes) {
  std::map<std::string, Axes> held;
  const auto hold = [&](const std::string& group, const Axes& axes, const Location& where) {
    Axes& already = held[group];
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes.at(i) && already.at(i)) {
        mistakes.add(where, fmt::format("bodies.{}: {} of the group '{}' is fixed, hinged or driven more than once",
                                        body.name, "xyz"[i], group));
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

}  // namespace

void read_constraints(Section& section, Body& body, const Folder& folder) {
  std::vector<Hinge> hinges;
  const bool fixed_good = section.optional("fixed", body.fixed);
  const bool hinges_good = section.optional("hinges", hinges);
  const bool driven_good = section.optional("driven", body.driven, folder);
  for (const Hinge& hinge : hinges) {
    body.fixed.push_back({.group = hinge.group, .axes = {true, true, true}, .hinge = true, .where = hinge.where});
  }
  const FaceGroups groups = read_face_groups(section);
  for (FixedGroup& fixed : body.fixed) {
    describe_group(groups, fixed.group);
  }
  for (DrivenGroup& driven : body.driven) {
    describe_group(groups, driven.group);
  }
  if (fixed_good && hinges_good && driven_good) {
    refuse_overlaps(body, section.mistakes());
  }
}

}  // namespace idiophone::scene
