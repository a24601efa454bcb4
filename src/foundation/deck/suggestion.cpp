#include "idiophone/foundation/deck/suggestion.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace idiophone::deck {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);  // distances of the letters of `a` so far to each beginning of `b`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchange = diagonal + (lower(letter) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchange, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t least_beginning = 3;  // letters that say which name they begin
  const auto is_begun = [name](const std::string& other) {
    return name.size() >= least_beginning && edit_distance(name, other.substr(0, name.size())) == 0;
  };
  const auto distance = [name](const std::string& other) { return edit_distance(name, other); };
  const auto rank = [&](const std::string& other) { return std::pair(!is_begun(other), distance(other)); };
  const auto nearest = std::ranges::min_element(known, {}, rank);
  if (nearest == known.end() ||
      (!is_begun(*nearest) && 2 * distance(*nearest) > std::max(name.size(), nearest->size()))) {
    return "";
  }
  return " (did you mean '" + *nearest + "'?)";
}

}  // namespace idiophone::deck
