#include "idiophone/foundation/deck/section.hpp"

#include <algorithm>

namespace idiophone::deck {

Section::Section(const Node& node, Mistakes& mistakes)
    : node_(node), mistakes_(mistakes), mistakes_before_(mistakes.count()) {
  if (node.kind != Node::Kind::map) {
    mistakes.add(node, "expected a map of keys, found " + describe(node));
  }
}

void Section::know(const std::string& key) {
  if (std::ranges::find(known_, key) == known_.end()) {
    known_.push_back(key);
  }
}

const Node* Section::find(const std::string& key) {
  know(key);
  if (node_.kind != Node::Kind::map) {
    return nullptr;
  }
  const auto found = std::ranges::find(node_.children, key, &Node::key);
  return found == node_.children.end() ? nullptr : &*found;
}

bool Section::missing(const std::string& key) {
  if (node_.kind == Node::Kind::map) {
    mistakes_.add(node_, fmt::format("the key '{}' is missing", key));
  }
  return false;
}

const Node& Section::note_default(const std::string& key, Node node) {
  node.path = node_.path_to(key);
  node.where = node_.where;
  node.key = key;
  node.key_where = node_.where;
  return node_.defaults.emplace_back(std::move(node));
}

bool Section::refuse(const std::string& key, const std::string& why) {
  const Node* child = find(key);
  if (child == nullptr) {
    return true;
  }
  mistakes_.add(child->key_where, child->path + ": " + why);
  return false;
}

bool Section::finish() {
  if (node_.kind != Node::Kind::map) {
    return false;
  }
  for (const Node& child : node_.children) {
    if (std::ranges::find(known_, child.key) != known_.end()) {
      continue;
    }
    mistakes_.add(child.key_where, fmt::format("{}: unknown key{}, known here: {}", child.path,
                                               suggestion(child.key, known_), fmt::join(known_, ", ")));
  }
  return mistakes_.count() == mistakes_before_;
}

}  // namespace idiophone::deck
