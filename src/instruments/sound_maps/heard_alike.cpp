#include "heard_alike.hpp"

#include <algorithm>
#include <vector>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/still_receivers.hpp"

namespace idiophone::sound_maps {

namespace {

/// A section of a resolved deck as text, without some keys of what it lists.
std::string section_text(const std::string& resolved_deck, const std::string& section,
                         const std::vector<std::string>& left_out = {}) {
  deck::Mistakes mistakes;
  deck::Node tree = deck::read_tree(resolved_deck, "resolved deck", {}, mistakes);
  const auto found = std::ranges::find(tree.children, section, &deck::Node::key);
  if (found == tree.children.end()) {
    return "";
  }
  for (deck::Node& entry : found->children) {
    std::erase_if(entry.children, [&](const deck::Node& node) { return std::ranges::count(left_out, node.key) > 0; });
  }
  return deck::resolved(*found);
}

}  // namespace

bool is_heard_alike(const SoundMap& source, const scene::Scene& scene, const std::string& resolved_deck,
                    const Placement& placement) {
  constexpr double rounding = 1e-9;  // relative
  const auto receivers = scene::still_receivers(scene.listeners);
  const double size = source.scalable->mesh_shape ? source.scalable->mesh_shape->size : 0.0;
  const auto same_place = [&](const scene::StillReceiver& one, const MapListener& other) {
    const Vector3 expected = placement.of(other.position);
    return one.name == other.name && (one.position - expected).norm() <= rounding * (size + expected.norm());
  };
  const auto same_section = [&](const char* section, const std::vector<std::string>& left_out) {
    return section_text(resolved_deck, section, left_out) == section_text(source.resolved_deck, section, left_out);
  };
  const bool is_open_air = !scene.radiation.floor && !scene.radiation.air.absorption;
  const std::vector<std::string> lengths = {"position", "separation"};
  return std::ranges::equal(receivers, source.listeners, same_place) && same_section("radiation", {}) &&
         same_section("listeners", placement.stays ? std::vector<std::string>{} : lengths) &&
         (placement.stays || is_open_air);
}

}  // namespace idiophone::sound_maps
