#include "idiophone/timbre/language/timbre_tree.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"

namespace idiophone::timbre {

namespace {

bool begins_with(const Expression& expression, const char* word) {
  return expression.kind == Expression::Kind::list && !expression.items.empty() &&
         expression.items.front().kind == Expression::Kind::word && expression.items.front().text == word;
}

/// Whether the word is a constant, or a node that needs no arguments, and so no parentheses.
bool is_word_of_its_own(const std::string& word) {
  const NodeType* type = find_node_type(word);
  return is_constant_word(word) ||
         (type != nullptr && std::ranges::all_of(type->arguments, [](const Argument& argument) {
            return argument.default_value.has_value();
          }));
}

/// Reads the forms of a text one by one.
class TreeReader {
 public:
  explicit TreeReader(Tree& tree) : tree_(tree) {}

  void read(std::vector<Expression> forms) {
    bool has_sound = false;
    for (Expression& form : forms) {
      if (begins_with(form, "parameter")) {
        read_parameter(form);
      } else if (begins_with(form, "define")) {
        read_definition(form);
      } else if (has_sound) {
        mistakes_.add(form.where, "there is a sound already; a tree has one, after its parameters and definitions");
      } else {
        tree_.sound = std::move(form);
        has_sound = true;
      }
    }
    if (!has_sound && mistakes_.count() == 0) {
      mistakes_.add({tree_.file.string(), 1, 1}, "there is no sound, only parameters and definitions");
    }
    mistakes_.raise();
  }

 private:
  /// The name in the second place of a form.
  bool read_name(const Expression& form, std::string& name) {
    if (form.items.size() < 2 || form.items[1].kind != Expression::Kind::word) {
      return complain(form.where, fmt::format("({} ...) needs a name", form.items[0].text));
    }
    name = form.items[1].text;
    const auto is_name = [&](const auto& other) { return other.name == name; };
    if (std::ranges::any_of(tree_.parameters, is_name) || std::ranges::any_of(tree_.definitions, is_name)) {
      return complain(form.items[1].where, fmt::format("the name '{}' is there already", name));
    }
    if (is_word_of_its_own(name)) {
      return complain(form.items[1].where, fmt::format("'{}' has a meaning already; choose another name", name));
    }
    return true;
  }

  void read_parameter(const Expression& form) {
    Parameter parameter{.where = form.where};
    if (!read_name(form, parameter.name)) {
      return;
    }
    if (form.items.size() > 3 || (form.items.size() == 3 && form.items[2].kind != Expression::Kind::number)) {
      complain(form.where, "write (parameter NAME) or (parameter NAME NUMBER)");
      return;
    }
    if (form.items.size() == 3) {
      parameter.default_value = form.items[2].number;
    }
    tree_.parameters.push_back(std::move(parameter));
  }

  void read_definition(Expression& form) {
    Definition definition;
    if (!read_name(form, definition.name)) {
      return;
    }
    if (form.items.size() != 3) {
      complain(form.where, "write (define NAME EXPRESSION)");
      return;
    }
    definition.expression = std::move(form.items[2]);
    tree_.definitions.push_back(std::move(definition));
  }

  bool complain(const deck::Location& where, const std::string& message) {
    mistakes_.add(where, message);
    return false;
  }

  Tree& tree_;
  deck::Mistakes mistakes_;
};

}  // namespace

Tree parse_tree(const std::string& text, const std::filesystem::path& file) {
  Tree tree;
  tree.file = file;
  TreeReader(tree).read(read_expressions(text, file.string()));
  return tree;
}

Tree read_tree_file(const std::filesystem::path& file) {
  return parse_tree(deck::read_text(file), file);
}

std::string to_text(const Tree& tree) {
  std::string text;
  for (const Parameter& parameter : tree.parameters) {
    text += parameter.default_value ? fmt::format("(parameter {} {})\n", parameter.name, *parameter.default_value)
                                    : fmt::format("(parameter {})\n", parameter.name);
  }
  for (const Definition& definition : tree.definitions) {
    text += fmt::format("(define {} {})\n", definition.name, to_text(definition.expression));
  }
  return text + to_text(tree.sound) + "\n";
}

}  // namespace idiophone::timbre
