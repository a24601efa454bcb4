#pragma once
// A map of the deck with known keys. It remembers the keys it was asked for, so any other is a mistake. It notes the
// defaults of the keys that are left out, so that the resolved deck (tree.hpp) has every key.

#include <string>
#include <vector>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/foundation/deck/node.hpp"
#include "idiophone/foundation/deck/values.hpp"

namespace idiophone::deck {

/// Lists and maps are empty where they are left out: there is nothing to note.
template <class T, class... Rules>
Node to_node(const std::vector<T>& /*values*/, const Rules&... /*rules*/) {
  return {};
}

class Section {
 public:
  /// Reports the mistake if the value is not a map; the section then stays silent.
  Section(const Node& node, Mistakes& mistakes);

  /// Reads the key's value by the read() for its type, and tells whether it is there and right.
  template <class T, class... Rules>
  bool required(const std::string& key, T& value, const Rules&... rules) {
    const Node* child = find(key);
    return child == nullptr ? missing(key) : read(*child, mistakes_, value, rules...);
  }

  /// The same for a key that may be left out: `value` then keeps its default. False only after a mistake.
  template <class T, class... Rules>
  bool optional(const std::string& key, T& value, const Rules&... rules) {
    const Node* child = find(key);
    return child == nullptr ? take_default(key, value, rules...) : read(*child, mistakes_, value, rules...);
  }

  /// A key that is known here, whether it is read or not.
  void know(const std::string& key);

  /// A known key that must not be given here, and why: "has no meaning with shape constant".
  bool refuse(const std::string& key, const std::string& why);

  /// The value of a known key; null where it is not given.
  [[nodiscard]] const Node* find(const std::string& key);

  /// Reports the keys that nobody asked for. Returns whether the whole section was free of mistakes.
  bool finish();

  [[nodiscard]] const Node& node() const { return node_; }
  [[nodiscard]] Mistakes& mistakes() { return mistakes_; }

 private:
  bool missing(const std::string& key);
  const Node& note_default(const std::string& key, Node node);

  /// Notes the default by the to_node() for its type. What has none is a section: it is read without keys, so that it
  /// notes its own defaults.
  template <class T, class... Rules>
  bool take_default(const std::string& key, T& value, const Rules&... rules) {
    if constexpr (requires { value.has_value(); }) {
      if (!value.has_value()) {
        return true;
      }
    }
    if constexpr (requires { to_node(value, rules...); }) {
      note_default(key, to_node(value, rules...));
      return true;
    } else {
      Node section;
      section.kind = Node::Kind::map;
      return read(note_default(key, std::move(section)), mistakes_, value, rules...);
    }
  }

  const Node& node_;
  Mistakes& mistakes_;
  std::size_t mistakes_before_;
  std::vector<std::string> known_;
};

/// Things that the deck gives names to: bodies, materials, ...
template <class T>
concept Named = requires(T thing) {
  thing.name = std::string();
};

/// Reads one thing, with the name that the deck gives it, and appends it.
template <class T, class... Rules>
bool read_entry(const Node& node, Mistakes& mistakes, std::vector<T>& things, const Rules&... rules) {
  bool good = true;
  T thing{};
  if constexpr (Named<T>) {
    good &= check_name(node.key, node.key_where, mistakes);
    thing.name = node.key;
  }
  good &= read(node, mistakes, thing, rules...);
  things.push_back(thing);
  return good;
}

/// Reads a map of named things, or a list of things without a name.
template <class T, class... Rules>
bool read(const Node& node, Mistakes& mistakes, std::vector<T>& things, const Rules&... rules) {
  if (node.kind != (Named<T> ? Node::Kind::map : Node::Kind::list)) {
    return mistakes.add(node,
                        fmt::format("expected {}, found {}", Named<T> ? "a map of names" : "a list", describe(node)));
  }
  bool good = true;
  for (const Node& child : node.children) {
    good &= read_entry(child, mistakes, things, rules...);
  }
  return good;
}

}  // namespace idiophone::deck
