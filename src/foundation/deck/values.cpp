#include "idiophone/foundation/deck/values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace idiophone::deck {

namespace {

std::string describe_limits(const Range& range) {
  std::vector<std::string> limits;
  const auto add = [&limits](const char* relation, double limit) {
    if (std::isfinite(limit)) {
      limits.push_back(fmt::format("{} {:.7g}", relation, limit));
    }
  };
  add("above", range.above);
  add("at least", range.at_least);
  add("below", range.below);
  add("at most", range.at_most);
  return fmt::format("{}{}{}", fmt::join(limits, " and "), range.unit.empty() ? "" : " ", range.unit);
}

std::string in_unit(const Range& range) {
  return range.unit.empty() ? "" : fmt::format(" ({})", range.unit);
}

std::optional<double> finite_number(const Node& node) {
  if (node.kind != Node::Kind::scalar || node.quoted) {
    return {};
  }
  const bool plus = node.text.starts_with('+') && !node.text.starts_with("+-");  // which from_chars does not know
  const char* end = node.text.data() + node.text.size();
  double number = 0.0;
  const auto [rest, error] = std::from_chars(node.text.data() + (plus ? 1 : 0), end, number);
  if (error != std::errc{} || rest != end || !std::isfinite(number)) {
    return {};
  }
  return number;
}

/// The first letters of a text, which may be a whole file that is not a deck.
std::string beginning(const std::string& text) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) {
    return text;
  }
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
    --end;  // a character of UTF-8 goes on here
  }
  return text.substr(0, end) + "...";
}

}  // namespace

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::nothing:
      return "nothing";
    case Node::Kind::scalar:
      return fmt::format("{0}{1}{0}", node.quoted ? '"' : '\'', beginning(node.text));
    case Node::Kind::list:
      return fmt::format("a list of {}", node.children.size());
    case Node::Kind::map:
      return "a map";
  }
  return {};
}

Node scalar(const std::string& text) {
  Node node;
  node.kind = Node::Kind::scalar;
  node.text = text;
  return node;
}

bool read(const Node& node, Mistakes& mistakes, double& number, const Range& range) {
  const std::optional<double> found = finite_number(node);
  if (!found) {
    return mistakes.add(node, fmt::format("expected a number{}, found {}", in_unit(range), describe(node)));
  }
  if (!range.contains(*found)) {
    return mistakes.add(node, fmt::format("must be {}, found {}", describe_limits(range), node.text));
  }
  number = *found;
  return true;
}

Node to_node(double number, const Range& /*range*/) {
  return std::isfinite(number) ? scalar(fmt::format("{}", number)) : Node{};
}

bool read(const Node& node, Mistakes& mistakes, int& number, const Range& range) {
  double found = 0.0;
  if (!read(node, mistakes, found, range)) {
    return false;
  }
  if (found != std::trunc(found) || std::abs(found) > std::numeric_limits<int>::max()) {
    return mistakes.add(node, fmt::format("expected a whole number{}, found {}", in_unit(range), describe(node)));
  }
  number = static_cast<int>(found);
  return true;
}

Node to_node(int number, const Range& /*range*/) {
  return scalar(std::to_string(number));
}

bool read(const Node& node, Mistakes& mistakes, Vector3& vector, const Range& range) {
  if (node.kind != Node::Kind::list || node.children.size() != 3) {
    return mistakes.add(
        node, fmt::format("expected a list of 3 numbers{}, e.g. [0, 0, 1], found {}", in_unit(range), describe(node)));
  }
  bool good = true;
  for (int i = 0; i < 3; ++i) {
    good &= read(node.children[i], mistakes, vector[i], range);
  }
  return good;
}

Node to_node(const Vector3& vector, const Range& range) {
  Node list;
  list.kind = Node::Kind::list;
  for (const double number : vector) {
    list.children.push_back(to_node(number, range));
  }
  return list;
}

bool read(const Node& node, Mistakes& mistakes, std::string& text) {
  if (node.kind != Node::Kind::scalar || node.text.empty()) {
    return mistakes.add(node, "expected text, found " + describe(node));
  }
  text = node.text;
  return true;
}

Node to_node(const std::string& text) {
  return scalar(text);
}

bool read(const Node& node, Mistakes& mistakes, std::filesystem::path& file, const Folder& folder) {
  std::string text;
  if (!read(node, mistakes, text)) {
    return false;
  }
  const std::filesystem::path found = (folder.path / text).lexically_normal();
  std::error_code unreachable;  // counts as missing
  if (!std::filesystem::is_regular_file(found, unreachable)) {
    const bool is_folder = std::filesystem::is_directory(found, unreachable);
    return mistakes.add(node, fmt::format("{} {}", is_folder ? "expected a file, found the folder" : "no such file:",
                                          std::filesystem::absolute(found).lexically_normal().string()));
  }
  file = found;
  node.file = std::filesystem::absolute(found).lexically_normal().string();
  return true;
}

Node to_node(const std::filesystem::path& file, const Folder& /*folder*/) {
  return scalar(file.string());
}

bool check_name(const std::string& name, const Location& where, Mistakes& mistakes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  if (!name.empty() && name.size() <= 64 && !name.starts_with('-') &&
      name.find_first_not_of(letters) == std::string::npos) {
    return true;
  }
  mistakes.add(where, fmt::format("'{}' can't name a file and a dataset; use 1 to 64 letters (a-z, A-Z), digits, - and "
                                  "_, not beginning with -",
                                  name));
  return false;
}

}  // namespace idiophone::deck
