#include "idiophone/foundation/deck/tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "document.hpp"
#include "idiophone/foundation/deck/overrides.hpp"
#include "idiophone/foundation/deck/values.hpp"

namespace idiophone::deck {

std::string read_text(const std::filesystem::path& file) {
  const auto fail = [&file](const char* why) {
    throw std::runtime_error(fmt::format("can't read {}: {}", file.string(), why));
  };
  if (std::filesystem::is_directory(file)) {
    fail("it is a folder; name the .yaml file in it");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    fail(std::strerror(errno));
  }
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) {
    fail(std::strerror(errno));
  }
  return text;
}

Node read_tree(const std::string& text, const std::string& file, const std::vector<std::string>& overrides,
               Mistakes& mistakes) {
  std::optional<Node> tree = parse_document(text, {file, 1, 1}, "", mistakes);
  if (!tree) {
    mistakes.raise();
  }
  if (tree->kind == Node::Kind::nothing) {
    throw DeckError(tree->where, "the deck is empty; docs/use/deck.md has an example");
  }
  if (tree->kind != Node::Kind::map) {
    throw DeckError(tree->where, "expected a map of keys, found " + describe(*tree));
  }
  for (const std::string& argument : overrides) {
    apply_override(*tree, argument, mistakes);
  }
  return *tree;
}

bool has_key(const std::filesystem::path& file, const std::vector<std::string>& overrides, const std::string& key) {
  Mistakes mistakes;
  const Node tree = read_tree(read_text(file), file.string(), overrides, mistakes);
  mistakes.raise();
  return std::ranges::find(tree.children, key, &Node::key) != tree.children.end();
}

}  // namespace idiophone::deck
