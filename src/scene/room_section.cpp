#include <cmath>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

constexpr int most_images = 30;       // reflections: 37 000 images
constexpr double longest_decay = 20;  // s

struct Absorption {};
constexpr Absorption absorption;
constexpr Range share{.at_least = 0.0, .at_most = 1.0};

/// A number, or a list of one for each octave band.
bool read(const Node& node, Mistakes& mistakes, OctaveBands& bands, const Absorption& /*rule*/) {
  if (node.kind != Node::Kind::list) {
    double value = 0.0;
    const bool good = deck::read(node, mistakes, value, share);
    bands.fill(value);
    return good;
  }
  if (node.children.size() != bands.size()) {
    return mistakes.add(node, fmt::format("expected a number, or a list of 6 numbers for the octaves at 125, 250, 500, "
                                          "1000, 2000 and 4000 Hz, found {}",
                                          describe(node)));
  }
  bool good = true;
  for (std::size_t band = 0; band < bands.size(); ++band) {
    good &= deck::read(node.children[band], mistakes, bands.at(band), share);
  }
  return good;
}

using Walls = std::array<OctaveBands, Room::walls>;

/// A map of the six walls, or what all of them have.
bool read(const Node& node, Mistakes& mistakes, Walls& walls, const Absorption& rule) {
  if (node.kind != Node::Kind::map) {
    OctaveBands bands{};
    const bool good = read(node, mistakes, bands, rule);
    walls.fill(bands);
    return good;
  }
  Section section(node, mistakes);
  std::size_t wall = 0;
  for (const char* name : {"left", "right", "front", "back", "floor", "ceiling"}) {
    section.required(name, walls.at(wall++), rule);
  }
  return section.finish();
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Room& room) {
  room.where = node.key_where;
  Section section(node, mistakes);
  section.required("size", room.size, Range{.at_least = 0.01, .at_most = 1000.0, .unit = "m"});
  section.optional("corner", room.corner, coordinate);
  section.required("absorption", room.absorption, absorption);
  section.optional("images", room.images, Range{.at_least = 1.0, .at_most = most_images});
  section.optional("late", room.late, Choices<bool>{{{"true", true}, {"false", false}}});
  return section.finish();
}

void check_room(const Node& node, Mistakes& mistakes, const Room& room, double speed) {
  double longest = 0.0;  // T60, s
  for (std::size_t band = 0; band < OctaveBands().size(); ++band) {
    longest = std::max(longest, 6.0 * std::log(10.0) / room.decay_rate(band, speed));
  }
  if (room.late && !(longest <= longest_decay)) {
    mistakes.add(node, fmt::format("the late field {}; let the walls absorb more, or give late: false",
                                   std::isfinite(longest)
                                       ? fmt::format("needs {:.3g} s to lose 60 dB, at most {:g} s are possible",
                                                     longest, longest_decay)
                                       : "never decays"));
  }
}

}  // namespace idiophone::scene
