#include "idiophone/study/measured_maps/measured_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/scene_file.hpp"

namespace idiophone::measured_maps {

using namespace deck;  // values, keys and sections

namespace {

/// Where a key is, or where it is missing.
Location place_of(Section& section, const std::string& key) {
  const Node* node = section.find(key);
  return node == nullptr ? section.node().where : node->where;
}

/// Integral of a force over time, N s. @param force  rows of (s, N)
double impulse_of(const std::vector<std::array<double, 2>>& force) {
  double impulse = 0.0;
  for (std::size_t row = 1; row < force.size(); ++row) {
    impulse += 0.5 * (force[row][1] + force[row - 1][1]) * (force[row][0] - force[row - 1][0]);
  }
  return impulse;
}

/// Microphones stand still, and hear by themselves.
void check_microphones(const std::vector<scene::Listener>& microphones, Mistakes& mistakes) {
  for (const scene::Listener& microphone : microphones) {
    if (microphone.head || microphone.path) {
      mistakes.add(microphone.where, fmt::format("listeners.{}: a microphone that records blows has no {}",
                                                 microphone.name, microphone.head ? "head" : "path"));
    }
  }
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, RecordedBlow& blow, const Folder& folder) {
  Section section(node, mistakes);
  section.required("sound", blow.sound, folder);
  blow.sound_where = place_of(section, "sound");
  section.required("at", blow.at, scene::coordinate);
  blow.at_where = place_of(section, "at");
  section.required("direction", blow.direction, scene::unit_vector);
  section.optional("time", blow.time, Range{.at_least = 0.0, .at_most = 1e5, .unit = "s"});
  if (section.find("force") != nullptr) {
    if (section.required("force", blow.force, folder, scene::time_and_value) && impulse_of(blow.force) <= 0.0) {
      section.mistakes().add(*section.find("force"), "has no impulse above 0: forces count along the direction");
    }
    for (const char* key : {"impulse", "contact"}) {
      section.refuse(key, "has no meaning beside force, whose table has both");
    }
    return section.finish();
  }
  section.optional("impulse", blow.impulse, Range{.above = 0.0, .at_most = 1e6, .unit = "N s"});
  section.optional("contact", blow.contact, Range{.at_least = 0.0, .at_most = 1.0, .unit = "s"});
  return section.finish();
}

static bool read(const Node& node, Mistakes& mistakes, MeasuredBody& body, const Folder& folder) {
  body.where = node.key_where;
  body.shape.name = body.name;
  body.shape.where = node.key_where;
  Section section(node, mistakes);
  scene::read_mesh(section, body.shape, folder);
  section.optional("rotation", body.shape.rotation, scene::turn);
  section.optional("position", body.shape.position, scene::coordinate);
  section.required("mass", body.mass, Range{.above = 0.0, .at_most = 1e9, .unit = "kg"});
  section.optional("full_scale", body.full_scale, Range{.at_least = 1e-9, .at_most = 1e9, .unit = "Pa"});
  section.optional("duration", body.duration, Range{.at_least = 0.05, .at_most = 60.0, .unit = "s"});
  scene::require_some(section, "blows", body.blows, folder);
  return section.finish();
}

bool has_measured_bodies(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return has_key(deck, overrides, "measured_bodies");
}

MeasuredDeck read_measured_deck(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  MeasuredDeck deck;
  scene::Scene& scene = deck.scene;
  const Folder folder{file.parent_path()};
  const Node tree = scene::read_scene_file(file, overrides, scene, [&](Section& section) {
    scene::require_some(section, "measured_bodies", deck.bodies, folder);
    scene::require_some(section, "listeners", scene.listeners, folder);
    section.optional("radiation", scene.radiation, scene.audio);
    scene::refuse_attached(scene.listeners, section.mistakes());
    check_microphones(scene.listeners, section.mistakes());
  });
  deck.resolved = resolved(tree);
  return deck;
}

}  // namespace idiophone::measured_maps
