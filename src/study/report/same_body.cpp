#include "same_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <vector>

#include "idiophone/foundation/deck/tree.hpp"

namespace idiophone::report {

namespace {

using deck::Node;
using nlohmann::json;

/// Keys of a body that its mesh contains, or that do not change its modes.
constexpr std::array<std::string_view, 7> without_effect = {"mesh",     "parameters", "scale", "rotation",
                                                            "position", "velocity",   "spin"};

const Node* child(const Node* node, const std::string& key) {
  if (node == nullptr) {
    return nullptr;
  }
  const auto found = std::ranges::find(node->children, key, &Node::key);
  return found == node->children.end() ? nullptr : &*found;
}

/// The path of the first value that differs; empty if there is none.
std::string first_difference(const Node* one, const Node* other) {
  if (one == nullptr || other == nullptr) {
    return one == other ? "" : (one == nullptr ? other : one)->path;
  }
  if (one->kind != other->kind || one->text != other->text) {
    return one->path;
  }
  std::set<std::string> keys;
  for (const Node* node : {one, other}) {
    std::ranges::transform(node->children, std::inserter(keys, keys.end()), &Node::key);
  }
  for (const std::string& key : keys) {
    if (const std::string path = first_difference(child(one, key), child(other, key)); !path.empty()) {
      return path;
    }
  }
  return "";
}

/// The section of a body in a resolved deck, without keys that do not matter.
Node body_section(const Node& tree, const std::string& body) {
  const Node* found = child(child(&tree, "bodies"), body);
  Node section = found != nullptr ? *found : Node();
  std::erase_if(section.children,
                [](const Node& key) { return std::ranges::find(without_effect, key.key) != without_effect.end(); });
  return section;
}

/// The names of the materials in a body's section: of all of it, of its groups, or of its layers.
std::vector<std::string> materials_of(const Node& section) {
  std::vector<std::string> names;
  const auto add = [&](const Node* material) {
    const Node* of_region = child(material, "material");
    if (material != nullptr) {
      names.push_back(of_region == nullptr ? material->text : of_region->text);
    }
  };
  add(child(&section, "material"));
  for (const char* key : {"materials", "layers"}) {
    if (const Node* regions = child(&section, key)) {
      std::ranges::for_each(regions->children, [&](const Node& region) { add(&region); });
    }
  }
  return names;
}

std::string difference_of_decks(const std::string& run, const std::string& modes, const std::string& body) {
  deck::Mistakes mistakes;
  const Node one = deck::read_tree(run, "the deck of the run", {}, mistakes);
  const Node other = deck::read_tree(modes, "the deck of the modes", {}, mistakes);
  const Node own = body_section(one, body), others = body_section(other, body);
  if (const std::string path = first_difference(&own, &others); !path.empty()) {
    return path;
  }
  for (const std::string& material : materials_of(own)) {
    const auto of = [&](const Node& tree) { return child(child(&tree, "materials"), material); };
    if (const std::string path = first_difference(of(one), of(other)); !path.empty()) {
      return path;
    }
  }
  return "";
}

std::string text_at(const json& facts, const json::json_pointer& place) {
  return facts.contains(place) && facts.at(place).is_string() ? facts.at(place).get<std::string>() : "";
}

}  // namespace

std::string difference_of_body(const json& run, const json& modes, const std::string& body) {
  const auto hash = json::json_pointer("/bodies") / body / "mesh_hash";
  const auto deck = json::json_pointer("/deck");
  const std::string own = text_at(run, hash), others = text_at(modes, hash);
  if (own.empty() || others.empty() || text_at(run, deck).empty() || text_at(modes, deck).empty()) {
    return "an older version of the program wrote one of the files, which does not say which mesh it is about";
  }
  if (own != others) {
    return "they are of another mesh";
  }
  const std::string path = difference_of_decks(text_at(run, deck), text_at(modes, deck), body);
  return path.empty() ? "" : fmt::format("{} has another value in their deck", path);
}

}  // namespace idiophone::report
