#include "sonic_objects.hpp"

#include <algorithm>

#include "idiophone/scene/ranges.hpp"
#include "sonic_variables.hpp"

namespace idiophone::timbre {

using namespace deck;  // values, keys and sections

void read_source_place(Section& section, SonicPlace& place, const Folder& folder, const std::string& what) {
  section.optional("at", place.at, scene::coordinate);
  section.optional("path", place.path, folder);
  if (section.find("body") != nullptr) {
    section.required("body", place.body);
  }
  if (static_cast<int>(place.at.has_value()) + static_cast<int>(place.path.has_value()) +
          static_cast<int>(!place.body.empty()) >
      1) {
    section.mistakes().add(section.node(), what + " has one place; give one of at, path and body");
  }
}

/// The rule for a pattern: a word, a number, or levels by angle.
struct PatternRule {};

/// Fills share or levels.
static bool read(const Node& node, Mistakes& mistakes, Directivity& directivity, const PatternRule& /*rule*/) {
  if (node.kind != Node::Kind::list) {
    return read(node, mistakes, directivity.share, scene::polar_pattern);
  }
  if (!read(node, mistakes, directivity.levels, NumberPair{})) {
    return false;
  }
  const auto ascends = [](const auto& a, const auto& b) { return a[0] >= b[0]; };
  const auto is_angle = [](const auto& row) { return row[0] >= 0.0 && row[0] <= 180.0 && row[1] <= 100.0; };
  if (directivity.levels.empty() || !std::ranges::all_of(directivity.levels, is_angle) ||
      std::ranges::adjacent_find(directivity.levels, ascends) != directivity.levels.end()) {
    return mistakes.add(
        node, "needs rows of angle and level: angles from 0 to 180 degrees, ascending, and levels up to 100 dB");
  }
  return true;
}

bool read(const Node& node, Mistakes& mistakes, Directivity& directivity) {
  Section section(node, mistakes);
  const Node* bands = section.find("bands");
  if (bands == nullptr) {
    section.know("pattern");
    if (const Node* pattern = section.find("pattern")) {
      read(*pattern, mistakes, directivity, PatternRule{});
    } else {
      section.required("pattern", directivity.share, scene::polar_pattern);
    }
  } else {
    section.refuse("pattern", "has no meaning beside bands, which have patterns of their own");
    constexpr std::size_t count = scene::OctaveBands().size();
    if (read(*bands, mistakes, directivity.bands, PatternRule{}) && directivity.bands.size() != count) {
      mistakes.add(*bands, fmt::format("needs {} patterns, for the octaves from {:g} Hz on, found {}", count,
                                       scene::lowest_octave, directivity.bands.size()));
    }
  }
  section.required("axis", directivity.axis, scene::unit_vector);
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, SonicObject& object, const Folder& folder) {
  Section section(node, mistakes);
  object.where = node.key_where;
  if (section.find("mesh") != nullptr) {
    scene::read_mesh(section, object.solid.emplace(), folder);
    section.refuse("size",
                   "belongs to a box, which has no mesh; `parameters: {size: ...}` is the size of the elements");
  } else {
    section.required("size", object.size, Range{.above = 0.0, .at_most = 1e6, .unit = "m"});
    for (const char* key : {"parameters", "meshing"}) {
      section.refuse(key, "belongs to an object with a mesh");
    }
  }
  section.optional("rotation", object.rotation, scene::turn);
  read_source_place(section, object.place, folder, "an object");
  if (!object.place.is_somewhere() && section.find("at") == nullptr && section.find("path") == nullptr) {
    mistakes.add(node, "an object needs a place; give at, path or body");
  }
  section.optional("surface_density", object.surface_density, Range{.at_least = 0.0, .at_most = 1e9, .unit = "kg/m2"});
  section.optional("absorption", object.absorption, Range{.at_least = 0.0, .at_most = 1.0});
  return section.finish();
}

}  // namespace idiophone::timbre
