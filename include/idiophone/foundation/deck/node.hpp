#pragma once
// A deck as a tree of plain values, each with its place. yaml-cpp is known only to document.cpp, which makes the tree,
// and resolved.cpp, which writes it.

#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::deck {

/// One value of a deck: nothing (a key without a value), a scalar, a list or a map.
struct Node {
  enum class Kind { nothing, scalar, list, map };
  Kind kind = Kind::nothing;
  std::string path;            ///< e.g. "bodies.plate.fixed.0"; empty for the whole deck
  Location where;              ///< of the value; of the key where there is no value
  std::string key;             ///< the key that holds it in a map, its index in a list
  Location key_where;          ///< of the key; of the value in a list
  std::string text;            ///< of a scalar
  bool quoted = false;         ///< a quoted scalar is text even where it looks like a number
  std::vector<Node> children;  ///< of a list or a map, in the deck's order

  // What the readers made of it, for the resolved deck (tree.hpp).
  mutable std::vector<Node> defaults;  ///< of a map: the keys that it leaves out, with the values that stand for them
  mutable std::string file;            ///< of a file's name: its absolute path

  /// The path of the child `name`.
  [[nodiscard]] std::string path_to(const std::string& name) const { return path.empty() ? name : path + "." + name; }
};

}  // namespace idiophone::deck
