#include "idiophone/foundation/deck/location.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace idiophone::deck {

namespace {

std::string lines(const std::vector<Mistake>& mistakes) {
  std::vector<std::string> texts;
  texts.reserve(mistakes.size());
  for (const Mistake& mistake : mistakes) {
    texts.push_back((mistake.where.file.empty() ? "" : to_string(mistake.where) + ": ") + mistake.message);
  }
  return fmt::format("{}", fmt::join(texts, "\n"));
}

}  // namespace

std::string to_string(const Location& where) {
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

DeckError::DeckError(const std::vector<Mistake>& mistakes) : std::runtime_error(lines(mistakes)) {}

}  // namespace idiophone::deck
