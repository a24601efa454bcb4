#include "idiophone/study/fitting/deck_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/foundation/deck/values.hpp"

namespace idiophone::fitting {

namespace {

using deck::Mistakes;
using deck::Node;

/// @throws std::runtime_error if there is no number at the key
Node number_node(const std::filesystem::path& file, const std::vector<std::string>& overrides, const std::string& key) {
  Mistakes mistakes;
  Node node = deck::read_tree(deck::read_text(file), file.string(), overrides, mistakes);
  mistakes.raise();
  std::istringstream words(key);
  for (std::string word; std::getline(words, word, '.');) {
    const auto child = std::ranges::find(node.children, word, &Node::key);
    if (child == node.children.end()) {
      throw std::runtime_error(
          fmt::format("{} has no key {}; write the number there from which the search starts", file.string(), key));
    }
    node = Node(*child);
  }
  double number = 0.0;
  if (!read(node, mistakes, number, deck::Range{})) {
    mistakes.raise();
  }
  return node;
}

}  // namespace

double number_at(const std::filesystem::path& deck, const std::vector<std::string>& overrides, const std::string& key) {
  return std::stod(number_node(deck, overrides, key).text);
}

std::string with_numbers(const std::filesystem::path& deck,
                         const std::vector<std::pair<std::string, double>>& numbers) {
  std::vector<std::pair<Node, double>> places;
  places.reserve(numbers.size());
  for (const auto& [key, number] : numbers) {
    places.emplace_back(number_node(deck, {}, key), number);
  }
  std::vector<std::string> lines;
  std::istringstream text(deck::read_text(deck));
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  std::ranges::sort(places, std::greater{},
                    [](const auto& place) { return place.first.where.column; });  // from the right
  for (const auto& [node, number] : places) {
    lines.at(node.where.line - 1).replace(node.where.column - 1, node.text.size(), fmt::format("{:.7g}", number));
  }
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace idiophone::fitting
