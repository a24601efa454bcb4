#include "idiophone/study/fitting/target.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace idiophone::fitting {

namespace {

constexpr double most_modes = 1e6;
constexpr double widest_band = 2400.0;  // cents to each side

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) {
    words.push_back(word);
  }
  return words;
}

std::optional<double> positive_number(const std::string& text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_good = error == std::errc{} && rest == text.data() + text.size() && value > 0 && std::isfinite(value);
  return is_good ? std::optional(value) : std::nullopt;
}

double frequency_of(const std::string& word, double a4) {
  const auto number = positive_number(word);
  return number ? *number : note_frequency(word, a4);
}

}  // namespace

double note_frequency(const std::string& note, double a4) {
  static const std::regex pattern("([A-Ga-g])(#|b)?(-?[0-9])");
  std::smatch parts;
  if (!std::regex_match(note, parts, pattern)) {
    throw std::runtime_error(
        fmt::format("'{}' is neither a frequency above 0 Hz nor a note such as F#3, Bb4 or A4", note));
  }
  constexpr int semitones[] = {9, 11, 0, 2, 4, 5, 7};  // of A, B, C, ... above C
  const int letter = std::toupper(static_cast<unsigned char>(parts[1].str()[0])) - 'A';
  const int sign = parts[2] == "#" ? 1 : parts[2] == "b" ? -1 : 0;
  const int above_a4 = semitones[letter] + sign - 9 + 12 * (std::stoi(parts[3]) - 4);
  return a4 * std::exp2(above_a4 / 12.0);
}

Target read_target(const std::string& text, const std::optional<std::string>& pitch, double a4) {
  Target target;
  target.are_ratios = text.find(':') != std::string::npos;
  for (const std::string& word : split(text, target.are_ratios ? ':' : ',')) {
    const auto ratio = positive_number(word);
    if (target.are_ratios && !ratio) {
      throw std::runtime_error(fmt::format("--target: '{}' is not a ratio; ratios are numbers, e.g. 1:4:10", word));
    }
    target.values.push_back(target.are_ratios ? *ratio : frequency_of(word, a4));
  }
  if (target.values.size() < (target.are_ratios ? 2 : 1)) {
    throw std::runtime_error("--target needs a frequency or a note, or two ratios, e.g. 1:4:10");
  }
  if (pitch && !target.are_ratios) {
    throw std::runtime_error("--pitch has a meaning only with ratios as --target");
  }
  if (pitch) {
    const double unit = frequency_of(*pitch, a4) / target.values.front();
    for (double& value : target.values) {
      value *= unit;
    }
    target.are_ratios = false;
  }
  return target;
}

WantedDecay read_wanted_decay(const std::string& text) {
  const std::vector<std::string> parts = split(text, '=');
  const auto mode = parts.size() == 2 ? positive_number(parts[0]) : std::nullopt;
  const auto seconds = parts.size() == 2 ? positive_number(parts[1]) : std::nullopt;
  if (!mode || !seconds || *mode != std::floor(*mode) || *mode > most_modes) {
    throw std::runtime_error(fmt::format(
        "--decay-time {}: expected MODE=SECONDS, the number of a mode and its decay time above 0, e.g. 1=2.5", text));
  }
  return {static_cast<int>(*mode), *seconds};
}

WantedLevel read_wanted_level(const std::string& text) {
  static const std::regex form(R"(([^=]+)=(at_least:|at_most:)?([-+]?[0-9]*\.?[0-9]+))");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    throw std::runtime_error(
        fmt::format("--level {}: expected LISTENER=DB, LISTENER=at_least:DB or LISTENER=at_most:DB, e.g. "
                    "ears.left=at_least:70",
                    text));
  }
  const auto kind = !parts[2].matched               ? WantedLevel::Kind::equal
                    : parts[2].str() == "at_least:" ? WantedLevel::Kind::at_least
                                                    : WantedLevel::Kind::at_most;
  return {.listener = parts[1], .kind = kind, .level = std::stod(parts[3])};
}

Band read_band(const std::string& text, double a4) {
  const std::vector<std::string> bounds = split(text, ':');
  if (bounds.size() == 2) {
    const Band band{frequency_of(bounds[0], a4), frequency_of(bounds[1], a4)};
    if (!(band.lower < band.upper)) {
      throw std::runtime_error(fmt::format("--avoid {}: the lowest frequency must be below the highest", text));
    }
    return band;
  }
  const std::vector<std::string> around = split(text, '~');
  const auto cents = around.size() == 2 ? positive_number(around[1]) : std::nullopt;
  if (!cents || *cents > widest_band) {
    throw std::runtime_error(fmt::format(
        "--avoid {}: expected LOWEST:HIGHEST, frequencies in Hz or notes, or a frequency or note and a distance from "
        "it of at most {:g} cents, e.g. 380:420 or A4~50",
        text, widest_band));
  }
  const double middle = frequency_of(around[0], a4);
  return {middle * std::exp2(-*cents / 1200), middle * std::exp2(*cents / 1200)};
}

}  // namespace idiophone::fitting
