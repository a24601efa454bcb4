#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

enum class ListenerType { mono, stereo, binaural };

/// Responses of the KEMAR manikin, where Debian's libmysofa1 puts them.
constexpr const char* default_responses = "/usr/share/libmysofa/default.sofa";

/// What a listener's head, or pair of microphones, is turned to.
struct ListenerAxes {
  Vector3 look, up, right;  // unit vectors, each across the others
};

/// Nothing after a mistake.
std::optional<ListenerAxes> read_axes(Section& section) {
  ListenerAxes axes;
  const bool has_look = section.required("look", axes.look, unit_vector);
  if (!section.required("up", axes.up, unit_vector) || !has_look) {
    return {};
  }
  axes.right = axes.look.cross(axes.up);
  if (axes.right.norm() < 1e-6) {
    section.mistakes().add(*section.find("up"), "is parallel to look; the ears' direction, look x up, is undefined");
    return {};
  }
  axes.right.normalize();
  axes.up = axes.right.cross(axes.look);
  return axes;
}

constexpr std::array pattern_names = {std::pair{"omni", 0.0}, std::pair{"cardioid", 0.5},
                                      std::pair{"figure_of_eight", 1.0}};

}  // namespace

bool read(const Node& node, Mistakes& mistakes, double& directivity, const PolarPattern& /*rule*/) {
  if (node.kind == Node::Kind::scalar && !node.text.empty() && std::isalpha(node.text.front()) == 0) {
    return read(node, mistakes, directivity, Range{.at_least = 0.0, .at_most = 1.0});
  }
  const auto* const found = std::ranges::find(pattern_names, node.text, &std::pair<const char*, double>::first);
  if (found == pattern_names.end()) {
    return mistakes.add(
        node, fmt::format("must be omni, cardioid, figure_of_eight or a number from 0 (omni) to 1 (figure of eight), "
                          "found {}{}",
                          describe(node), suggestion(node.text, {"omni", "cardioid", "figure_of_eight"})));
  }
  directivity = found->second;
  return true;
}

Node to_node(double directivity, const PolarPattern& /*rule*/) {
  const auto* const found = std::ranges::find(pattern_names, directivity, &std::pair<const char*, double>::second);
  return found == pattern_names.end() ? to_node(directivity, Range{}) : deck::scalar(found->first);
}

namespace {

/// The key position or path; gives the position at time 0.
bool read_position(Section& section, Listener& listener, Vector3& position, const Folder& folder) {
  static_cast<void>(section.find("position"));  // known before the path
  if (section.find("path") == nullptr) {
    return section.required("position", position, coordinate);
  }
  section.refuse("position", "the path gives the position already; give one of the two");
  if (!section.optional("path", listener.path, folder)) {
    return false;
  }
  position = listener.path->at(0.0).position;
  return true;
}

void read_mono(Section& section, Listener& listener, const Vector3& position) {
  Receiver receiver{.channel = listener.name, .position = position};
  if (section.optional("pattern", receiver.directivity, polar_pattern)) {
    if (receiver.directivity > 0.0) {
      section.required("look", receiver.axis, unit_vector);
    } else {
      section.refuse("look", "an omnidirectional microphone has no axis; give it another pattern, or leave look out");
    }
  } else {
    static_cast<void>(section.find("look"));  // needed or not: that depends on the pattern
  }
  listener.receivers = {receiver};
}

void read_stereo(Section& section, Listener& listener, const Vector3& position) {
  double separation = 0.2;
  double directivity = 0.0;
  double degrees = 0.0;
  const std::optional<ListenerAxes> axes = read_axes(section);
  section.optional("separation", separation, Range{.at_least = 0.0, .at_most = 1e3, .unit = "m"});
  if (section.optional("pattern", directivity, polar_pattern)) {
    if (directivity > 0.0) {
      section.required("angle", degrees, Range{.at_least = 0.0, .at_most = 360.0, .unit = "degrees"});
    } else {
      section.refuse("angle",
                     "omnidirectional microphones have no axis; give them another pattern, or leave angle out");
    }
  } else {
    static_cast<void>(section.find("angle"));  // needed or not: that depends on the pattern
  }
  if (!axes) {
    return;
  }
  const double half_angle = 0.5 * degrees * std::numbers::pi / 180.0;
  for (const auto& [side, name] : {std::pair{-1.0, ".left"}, std::pair{1.0, ".right"}}) {
    listener.receivers.push_back({.channel = listener.name + name,
                                  .position = position + side * 0.5 * separation * axes->right,
                                  .axis = std::cos(half_angle) * axes->look + side * std::sin(half_angle) * axes->right,
                                  .directivity = directivity});
  }
}

void read_binaural(Section& section, Listener& listener, const Vector3& position, const Folder& folder) {
  const std::optional<ListenerAxes> axes = read_axes(section);
  Head head{.responses = default_responses, .where = section.node().key_where};
  section.optional("hrtf", head.responses, folder);
  if (const Node* file = section.find("hrtf")) {
    head.where = file->where;
  } else if (!std::filesystem::exists(default_responses)) {
    section.mistakes().add(section.node(), fmt::format("there are no head-related responses in {}; install the package "
                                                       "libmysofa1, or name a .sofa file with the key hrtf",
                                                       default_responses));
  }
  if (axes) {
    head.look = axes->look;
    head.up = axes->up;
  }
  listener.head = head;
  for (const char* name : {".left", ".right"}) {
    listener.receivers.push_back({.channel = listener.name + name, .position = position, .axis = head.look});
  }
}

/// The names of recorded bodies are in the recordings; they are checked when these are open.
void check_attached(const Listener& listener, const Scene& scene, Mistakes& mistakes) {
  if (!listener.attached) {
    return;
  }
  const std::string key = fmt::format("listeners.{}.attached: ", listener.name);
  if (scene.radiation.model == RadiationModel::waves) {
    mistakes.add(listener.where, key +
                                     "listeners to the model waves stand still or have a path; take another model, or "
                                     "strike the body with a load with balanced: true");
  }
  std::vector<std::string> names;
  std::ranges::transform(scene.bodies, std::back_inserter(names), &Body::name);
  if (!names.empty() && scene.recorded_bodies.empty() && std::ranges::find(names, *listener.attached) == names.end()) {
    mistakes.add(listener.where, fmt::format("{}there is no body '{}'{}", key, *listener.attached,
                                             suggestion(*listener.attached, names)));
  }
}

/// What is wrong with a place at a time (s); empty if nothing is.
std::string wrong_place(const Vector3& place, double time, const Radiation& radiation) {
  if (radiation.floor && radiation.floor->height(place) < 0.0) {
    return fmt::format("{:.4g} m behind radiation.floor at {} s; move it, or the floor",
                       -radiation.floor->height(place), time);
  }
  if (radiation.room && radiation.room->distance_outside(place) > 0.0) {
    return fmt::format("{:.4g} m outside radiation.room at {} s; move it, or make the room larger",
                       radiation.room->distance_outside(place), time);
  }
  return {};
}

/// Against the floor and the room: where it is at time 0 and at the points of its path.
void check_places(const Listener& listener, const Radiation& radiation, Mistakes& mistakes) {
  std::vector<double> times = {0.0};
  for (std::size_t i = 0; listener.path && i < listener.path->points.size(); ++i) {
    times.push_back(listener.path->points[i].time);
  }
  for (const double time : times) {
    for (const Receiver& receiver : listener.receivers) {
      const std::string wrong = wrong_place(listener.place(receiver, time).position, time, radiation);
      if (!wrong.empty()) {
        mistakes.add(listener.where, fmt::format("listeners.{}: {} is {}", listener.name, receiver.channel, wrong));
        return;
      }
    }
  }
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Listener& listener, const Folder& folder) {
  const Choices<ListenerType> types{
      {{"mono", ListenerType::mono}, {"stereo", ListenerType::stereo}, {"binaural", ListenerType::binaural}}};
  listener.where = node.key_where;
  Section section(node, mistakes);
  ListenerType type{};
  if (!section.required("type", type, types)) {
    return false;  // the other keys depend on it
  }
  Vector3 position = Vector3::Zero();
  read_position(section, listener, position, folder);
  section.optional("attached", listener.attached);
  if (listener.path) {
    section.refuse("attached", "the path gives the motion already; give one of the two");
  }
  if (type == ListenerType::stereo) {
    read_stereo(section, listener, position);
  } else if (type == ListenerType::binaural) {
    read_binaural(section, listener, position, folder);
  } else {
    read_mono(section, listener, position);
  }
  return section.finish();
}

void refuse_attached(std::span<const Listener> listeners, Mistakes& mistakes) {
  for (const Listener& listener : listeners) {
    if (listener.attached) {
      mistakes.add(listener.where, "a listener can be attached to a body of a run only; leave `attached` out");
    }
  }
}

void check_listeners(const Scene& scene, Mistakes& mistakes) {
  for (const Listener& listener : scene.listeners) {
    const std::string name = "listeners." + listener.name;
    check_attached(listener, scene, mistakes);
    if (listener.path && listener.path->fastest() >= scene.radiation.air.speed) {
      mistakes.add(listener.path->where,
                   fmt::format("{}.path: moves at up to {:.4g} m/s; it must be slower than sound, {} m/s", name,
                               listener.path->fastest(), scene.radiation.air.speed));
    }
    check_places(listener, scene.radiation, mistakes);
  }
}

}  // namespace idiophone::scene
