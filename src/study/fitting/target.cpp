#include "idiophone/study/fitting/target.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace idiophone::fitting {

namespace {

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

}  // namespace idiophone::fitting
