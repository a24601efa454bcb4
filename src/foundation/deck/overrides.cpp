#include "idiophone/foundation/deck/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <vector>

#include "document.hpp"
#include "idiophone/foundation/deck/suggestion.hpp"

namespace idiophone::deck {

namespace {

Node& append(Node& parent, const std::string& name) {
  Node& child = parent.children.emplace_back();
  child.path = parent.path_to(name);
  child.key = name;
  return child;
}

Node* element(Node& list, const std::string& name, const Location& where, Mistakes& mistakes) {
  std::size_t index = 0;
  const char* end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data(), end, index);
  if (error != std::errc{} || rest != end || index > list.children.size()) {
    mistakes.add(where, fmt::format("{}: is a list; expected an index from 0 to {} (one after the last appends), found "
                                    "'{}'",
                                    list.path, list.children.size(), name));
    return nullptr;
  }
  return index < list.children.size() ? &list.children[index] : &append(list, name);
}

Node* entry(Node& map, const std::string& name) {
  map.kind = Node::Kind::map;  // a key without a value becomes one
  const auto found = std::ranges::find(map.children, name, &Node::key);
  if (found != map.children.end()) {
    return &*found;
  }
  return &append(map, name);
}

// The child of that name, made if need be; null after a mistake.
Node* step(Node& parent, const std::string& name, const Location& where, Mistakes& mistakes) {
  if (parent.kind == Node::Kind::list) {
    return element(parent, name, where, mistakes);
  }
  if (parent.kind != Node::Kind::scalar) {
    return entry(parent, name);
  }
  mistakes.add(where,
               fmt::format("{}: is the single value '{}' and has no '{}' inside", parent.path, parent.text, name));
  return nullptr;
}

/// Removes the value that the deck has at a path of keys and indices.
void remove(Node& parent, const std::string& path, const Location& where, Mistakes& mistakes) {
  const std::string name = path.substr(0, path.find('.'));
  const auto found = std::ranges::find(parent.children, name, &Node::key);
  if (found == parent.children.end()) {
    std::vector<std::string> names;
    std::ranges::transform(parent.children, std::back_inserter(names), &Node::key);
    mistakes.add(where, fmt::format("{}: the deck has no such value to remove{}", parent.path_to(name),
                                    suggestion(name, names)));
  } else if (name != path) {
    remove(*found, path.substr(name.size() + 1), where, mistakes);
  } else if (parent.kind == Node::Kind::list) {
    mistakes.add(where, fmt::format("{}: an element of a list can't be removed; give the whole list", found->path));
  } else {
    parent.children.erase(found);
  }
}

}  // namespace

void apply_override(Node& deck, const std::string& argument, Mistakes& mistakes) {
  Location where{"--set " + argument, 1, 1};
  const std::size_t equals = argument.find('=');
  const std::string path = argument.substr(0, equals);
  if (equals == std::string::npos || ("." + path + ".").find("..") != std::string::npos) {
    mistakes.add(where, "expected KEY.PATH=VALUE, e.g. --set time.duration=0.5");
    return;
  }
  if (argument.substr(equals + 1) == "null") {
    where.column = 1;
    remove(deck, path, where, mistakes);
    return;
  }
  const Location value_where{where.file, 1, static_cast<int>(equals) + 2};
  std::optional<Node> value = parse_document(argument.substr(equals + 1), value_where, path, mistakes);
  if (!value) {
    return;
  }
  Node* place = &deck;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    where.column = static_cast<int>(start) + 1;
    place = step(*place, path.substr(start, end - start), where, mistakes);
    if (place == nullptr) {
      return;
    }
    if (place->key_where.file.empty()) {
      place->key_where = place->where = where;
    }
    start = end + 1;
  }
  value->key = place->key;
  value->key_where = where;
  *place = std::move(*value);
}

}  // namespace idiophone::deck
