#include "idiophone/deck/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "document.hpp"

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

}  // namespace

void apply_override(Node& deck, const std::string& argument, Mistakes& mistakes) {
  Location where{"--set " + argument, 1, 1};
  const std::size_t equals = argument.find('=');
  const std::string path = argument.substr(0, equals);
  if (equals == std::string::npos || ("." + path + ".").find("..") != std::string::npos) {
    mistakes.add(where, "expected KEY.PATH=VALUE, e.g. --set time.duration=0.5");
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
