#include <Eigen/Geometry>

#include "ranges.hpp"
#include "sections.hpp"

namespace idiophone::scene {

namespace {

enum class ListenerType { mono, stereo };

/// The unit vector to the listener's right; nothing after a mistake.
std::optional<Vector3> read_right(Section& section) {
  Vector3 look = Vector3::Zero();
  Vector3 up = Vector3::Zero();
  const bool has_look = section.required("look", look, unit_vector);
  if (!section.required("up", up, unit_vector) || !has_look) {
    return {};
  }
  const Vector3 right = look.cross(up);
  if (right.norm() < 1e-6) {
    section.mistakes().add(*section.find("up"), "is parallel to look; the ears' direction, look x up, is undefined");
    return {};
  }
  return right.normalized();
}

void read_ears(Section& section, Listener& listener, const Vector3& position) {
  double separation = 0.2;
  const std::optional<Vector3> right = read_right(section);
  const bool good = section.optional("separation", separation, Range{.above = 0.0, .at_most = 1e3, .unit = "m"});
  if (!good || !right) {
    return;
  }
  const Vector3 half_way = 0.5 * separation * *right;
  listener.receivers = {{.channel = listener.name + ".left", .position = position - half_way},
                        {.channel = listener.name + ".right", .position = position + half_way}};
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Listener& listener) {
  const Choices<ListenerType> types{{{"mono", ListenerType::mono}, {"stereo", ListenerType::stereo}}};
  listener.where = node.key_where;
  Section section(node, mistakes);
  ListenerType type{};
  if (!section.required("type", type, types)) {
    return false;  // the other keys depend on it
  }
  Vector3 position = Vector3::Zero();
  section.required("position", position, coordinate);
  if (type == ListenerType::stereo) {
    read_ears(section, listener, position);
  } else {
    listener.receivers = {{.channel = listener.name, .position = position}};
  }
  return section.finish();
}

}  // namespace idiophone::scene
