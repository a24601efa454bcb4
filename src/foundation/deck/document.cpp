#include "document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <vector>

#include "idiophone/foundation/terminal_text.hpp"

namespace idiophone::deck {

namespace {

constexpr int deepest = 20;           // no deck needs more
constexpr int most_values = 200'000;  // some 10 000 bodies; ends aliases of aliases of aliases

Node empty_node(const std::string& path, const Location& where) {
  Node node;
  node.path = path;
  node.where = where;
  return node;
}

class Converter {
 public:
  Converter(const Location& origin, Mistakes& mistakes) : origin_(origin), mistakes_(mistakes) {}

  [[nodiscard]] Location place(const YAML::Mark& mark) const {
    const int first_column = mark.line == 0 ? origin_.column : 1;
    return {origin_.file, origin_.line + mark.line, first_column + mark.column};
  }

  [[nodiscard]] Node convert(const YAML::Node& yaml, const std::string& path, int depth) {
    Node node = empty_node(path, place(yaml.Mark()));
    check_size(yaml, node.where, depth);
    refuse_tag(yaml, node);
    outer_.push_back(yaml);
    if (yaml.IsScalar()) {
      node.kind = Node::Kind::scalar;
      node.text = yaml.Scalar();
      node.quoted = yaml.Tag() == "!";
    } else if (yaml.IsSequence()) {
      node.kind = Node::Kind::list;
      for (const YAML::Node& item : yaml) {
        add_item(node, item, depth);
      }
    } else if (yaml.IsMap()) {
      node.kind = Node::Kind::map;
      std::unordered_set<std::string> names;
      for (const auto& entry : yaml) {
        add_entry(node, names, entry.first, entry.second, depth);
      }
    }
    outer_.pop_back();
    return node;
  }

 private:
  /// @throws DeckError for what has no end, or is far larger than any deck
  void check_size(const YAML::Node& yaml, const Location& where, int depth) {
    if (std::ranges::any_of(outer_, [&](const YAML::Node& outer) { return outer.is(yaml); })) {
      throw DeckError(where, "an alias contains itself");
    }
    if (depth > deepest) {
      throw DeckError(where, fmt::format("lists and maps are nested more than {} levels deep", deepest));
    }
    if (++values_ > most_values) {
      throw DeckError(where, fmt::format("there are more than {} values, with those that aliases repeat", most_values));
    }
  }

  void add_item(Node& list, const YAML::Node& item, int depth) {
    const std::string index = std::to_string(list.children.size());
    Node child = convert(item, list.path_to(index), depth + 1);
    child.key = index;
    child.key_where = child.where;
    list.children.push_back(std::move(child));
  }

  /// @param names  of the entries before
  void add_entry(Node& map, std::unordered_set<std::string>& names, const YAML::Node& key, const YAML::Node& value,
                 int depth) {
    const Location where = place(key.Mark());
    if (!key.IsScalar() || key.Scalar().empty()) {
      mistakes_.add(where, map.path_to("?") + ": a key is a name, found something else");
      return;
    }
    if (!names.insert(key.Scalar()).second) {
      const auto first = std::ranges::find(map.children, key.Scalar(), &Node::key);
      mistakes_.add(where, fmt::format("{}: is said twice, first at {}; leave one out", first->path,
                                       to_string(first->key_where)));
      return;
    }
    Node child = convert(value, map.path_to(key.Scalar()), depth + 1);
    child.key = key.Scalar();
    child.key_where = where;
    if (child.kind == Node::Kind::nothing) {
      child.where = where;  // yaml-cpp marks whatever comes next
    }
    map.children.push_back(std::move(child));
  }

  void refuse_tag(const YAML::Node& yaml, const Node& node) {
    const std::string& tag = yaml.Tag();
    if (!tag.empty() && tag != "?" && tag != "!") {
      mistakes_.add(node, "has the tag '" + tag + "'; decks know no tags");
    }
  }

  const Location& origin_;
  Mistakes& mistakes_;
  std::vector<YAML::Node> outer_;  // lists and maps around the present value
  int values_ = 0;
};

/// The place of the character at the offset.
Location place_at(const std::string& text, std::size_t offset, const Location& origin) {
  const std::string_view before = std::string_view(text).substr(0, offset);
  const auto lines = static_cast<int>(std::ranges::count(before, '\n'));
  const auto column = static_cast<int>(offset - (before.rfind('\n') + 1));  // npos + 1 is 0
  return {origin.file, origin.line + lines, (lines == 0 ? origin.column : 1) + column};
}

/// Control characters would steer the terminals that show the deck, and yaml-cpp takes the character 4 for the end of
/// the text and would drop what follows.
bool has_wrong_character(const std::string& text, const Location& origin, Mistakes& mistakes) {
  for (std::size_t at = 0; at < text.size();) {
    const Character next = first_character(std::string_view(text).substr(at));
    if (!next.is_utf8 || (is_control(next.code) && next.code != U'\r')) {
      const auto code = static_cast<unsigned>(next.code);
      mistakes.add(place_at(text, at, origin),
                   (next.is_utf8 ? fmt::format("a control character (code {})", code)
                                 : fmt::format("a byte that is not UTF-8 ({:#04x})", code)) +
                       "; a deck is plain UTF-8 text");
      return true;
    }
    at += next.bytes;
  }
  return false;
}

/// Notes where a document starts and lets everything else pass.
class StartOfDocument : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { mark_ = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {}
  void OnMapEnd() override {}

  [[nodiscard]] const YAML::Mark& mark() const { return mark_; }

 private:
  YAML::Mark mark_;
};

/// YAML::Load passes over all that follows the first document, and YAML::LoadAll never returns from a stray comma.
std::optional<YAML::Mark> start_of_second_document(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  StartOfDocument start;
  const bool more = parser.HandleNextDocument(start) && parser.HandleNextDocument(start);
  return more ? std::optional(start.mark()) : std::nullopt;
}

std::string explain(const YAML::ParserException& error) {
  if (dynamic_cast<const YAML::DeepRecursion*>(&error) != nullptr) {
    return "nested too deeply";
  }
  if (error.msg == YAML::ErrorMsg::EOF_IN_SCALAR) {
    return "the text ends inside quotes; close them";
  }
  return error.msg;
}

}  // namespace

std::optional<Node> parse_document(const std::string& text, const Location& origin, const std::string& path,
                                   Mistakes& mistakes) {
  if (has_wrong_character(text, origin, mistakes)) {
    return {};
  }
  Converter converter(origin, mistakes);
  try {
    // The comment at the end makes yaml-cpp see an unclosed quote, which it passes over before a final line break.
    const std::string closed = text + "\n#";
    if (const std::optional<YAML::Mark> second = start_of_second_document(closed)) {
      mistakes.add(converter.place(*second), "not YAML, or a second document; a deck is a single one and ends before");
      return {};
    }
    const YAML::Node document = YAML::Load(closed);
    return document.IsNull() ? empty_node(path, origin) : converter.convert(document, path, 0);
  } catch (const YAML::ParserException& error) {
    const Location end = place_at(text, text.size(), origin);
    const Location where = converter.place(error.mark);
    const bool in_text = std::tie(where.line, where.column) < std::tie(end.line, end.column);
    mistakes.add(in_text ? where : end, "not YAML: " + explain(error));
    return {};
  }
}

}  // namespace idiophone::deck
