#include "idiophone/timbre/language/expression.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace idiophone::timbre {

namespace {

using deck::DeckError;
using deck::Location;

/// Walks over a text and counts lines and columns.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, const std::string& file) : text_(text), where_{file, 1, 1} {}

  std::vector<Expression> read() {
    std::vector<Expression> open(1);  // the lists that have begun; first the whole text
    while (skip_blanks()) {
      if (current() == '(') {
        if (open.size() > deepest) {
          throw DeckError(where_, fmt::format("lists are more than {} deep; name parts by (define NAME ...)", deepest));
        }
        open.push_back({.where = where_});
        advance();
      } else if (current() == ')') {
        if (open.size() == 1) {
          throw DeckError(where_, "this ) closes nothing");
        }
        advance();
        Expression list = std::move(open.back());
        open.pop_back();
        open.back().items.push_back(std::move(list));
      } else {
        open.back().items.push_back(current() == '"' ? read_quoted() : read_atom());
      }
    }
    if (open.size() > 1) {
      throw DeckError(open.back().where, "this ( is not closed");
    }
    return std::move(open.front().items);
  }

 private:
  [[nodiscard]] char current() const { return text_[position_]; }
  [[nodiscard]] bool at_end() const { return position_ == text_.size(); }

  void advance() {
    if (current() == '\n') {
      ++where_.line;
      where_.column = 0;
    }
    ++where_.column;
    ++position_;
  }

  /// Whether anything comes after blanks and comments.
  bool skip_blanks() {
    bool comment = false;
    for (; !at_end(); advance()) {
      comment = (comment || current() == ';') && current() != '\n';
      if (!comment && blanks.find(current()) == std::string_view::npos) {
        return true;
      }
    }
    return false;
  }

  Expression read_quoted() {
    Expression quoted{.kind = Expression::Kind::text, .where = where_};
    for (advance(); !at_end() && current() != '"' && current() != '\n'; advance()) {
      quoted.text += current();
    }
    if (at_end() || current() == '\n') {
      throw DeckError(quoted.where, "this \" has no partner in its line");
    }
    advance();
    return quoted;
  }

  Expression read_atom() {
    Expression atom{.kind = Expression::Kind::word, .where = where_};
    const std::size_t begin = position_;
    while (!at_end() && ends.find(current()) == std::string_view::npos) {
      advance();
    }
    const std::string_view text = text_.substr(begin, position_ - begin);
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), atom.number);
    if (!digits.empty() && rest == digits.data() + digits.size()) {
      if (error != std::errc{} || !std::isfinite(atom.number)) {
        throw DeckError(atom.where, fmt::format("'{}' is not a finite number of double precision", text));
      }
      atom.kind = Expression::Kind::number;
    }
    atom.text = text;
    return atom;
  }

  static constexpr std::string_view blanks = " \t\r\n";
  static constexpr std::string_view ends = " \t\r\n();\"";
  std::string_view text_;
  std::size_t position_ = 0;
  Location where_;
};

}  // namespace

std::vector<Expression> read_expressions(const std::string& text, const std::string& file) {
  return ExpressionReader(text, file).read();
}

std::string to_text(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::number:
      return fmt::format("{}", expression.number);
    case Expression::Kind::word:
      return expression.text;
    case Expression::Kind::text:
      return '"' + expression.text + '"';
    case Expression::Kind::list:
      break;
  }
  std::string text;
  for (const Expression& item : expression.items) {
    text += (text.empty() ? "" : " ") + to_text(item);
  }
  return "(" + text + ")";
}

std::string describe(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::list:
      return "a list";
    case Expression::Kind::text:
      return to_text(expression);
    default:
      return "'" + to_text(expression) + "'";
  }
}

}  // namespace idiophone::timbre
