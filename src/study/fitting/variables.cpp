#include "idiophone/study/fitting/variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/study/fitting/deck_numbers.hpp"

namespace idiophone::fitting {

namespace {

double read_number(std::string_view text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size() || !std::isfinite(value)) {
    throw std::runtime_error(fmt::format("'{}' is not a number", text));
  }
  return value;
}

/// What stands before and after a sign.
/// @throws std::runtime_error  that has `expected`, where there is no such sign
std::pair<std::string_view, std::string_view> halves(std::string_view text, char sign, const char* expected) {
  const std::size_t place = text.find(sign);
  if (place == std::string_view::npos) {
    throw std::runtime_error(fmt::format("expected {}", expected));
  }
  return {text.substr(0, place), text.substr(place + 1)};
}

Variable read_variable(std::string_view text, const std::filesystem::path& deck,
                       const std::vector<std::string>& overrides) {
  constexpr const char* form = "KEY=LOWEST:HIGHEST, e.g. bodies.bar.parameters.centre=0.003:0.01";
  const auto [key, bounds] = halves(text, '=', form);
  const auto [lower, upper] = halves(bounds, ':', form);
  Variable variable{.key = std::string(key), .lower = read_number(lower), .upper = read_number(upper)};
  if (!(variable.lower < variable.upper)) {
    throw std::runtime_error("the lowest value must be below the highest");
  }
  variable.start = number_at(deck, overrides, variable.key);
  if (variable.start < variable.lower || variable.start > variable.upper) {
    throw std::runtime_error(fmt::format("the deck's value, {:g}, is not within these bounds", variable.start));
  }
  return variable;
}

Scatter read_scatter(std::string_view text, const std::filesystem::path& deck,
                     const std::vector<std::string>& overrides) {
  const auto [key, deviation] = halves(text, '=', "KEY=DEVIATION, e.g. bodies.bar.parameters.centre=0.0001 or =2%");
  Scatter scatter{.key = std::string(key)};
  scatter.mean = number_at(deck, overrides, scatter.key);
  scatter.deviation = deviation.ends_with('%')
                          ? std::abs(scatter.mean) * read_number(deviation.substr(0, deviation.size() - 1)) / 100
                          : read_number(deviation);
  if (!(scatter.deviation > 0)) {
    throw std::runtime_error("the standard deviation must be above 0");
  }
  return scatter;
}

/// @param read    makes a number of the deck of one text
/// @param option  that has the texts
template <class Read>
auto read_all(const std::vector<std::string>& texts, const char* option, Read read) {
  std::vector<decltype(read(texts.front()))> all;
  for (const std::string& text : texts) {
    try {
      all.push_back(read(text));
      if (std::ranges::count(all, all.back().key, [](const auto& one) { return one.key; }) > 1) {
        throw std::runtime_error("this key is given twice");
      }
    } catch (const deck::DeckError&) {
      throw;  // says itself where the mistake is
    } catch (const std::runtime_error& refused) {
      throw std::runtime_error(fmt::format("{} {}: {}", option, text, refused.what()));
    }
  }
  return all;
}

}  // namespace

std::vector<Variable> read_variables(const std::vector<std::string>& texts, const std::filesystem::path& deck,
                                     const std::vector<std::string>& overrides) {
  return read_all(texts, "--vary", [&](const std::string& text) { return read_variable(text, deck, overrides); });
}

std::vector<Scatter> read_scatters(const std::vector<std::string>& texts, const std::filesystem::path& deck,
                                   const std::vector<std::string>& overrides) {
  return read_all(texts, "--scatter", [&](const std::string& text) { return read_scatter(text, deck, overrides); });
}

}  // namespace idiophone::fitting
