#include "mutations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <vector>

namespace idiophone::mutants {

namespace {

const std::array<std::string, 24> hostile_numbers = {"0",
                                                     "-0.0",
                                                     "-1",
                                                     "0.5",
                                                     "1e-320",
                                                     "1e-300",
                                                     "1e-10",
                                                     "1e10",
                                                     "1e300",
                                                     "1e999",
                                                     "-1e300",
                                                     ".nan",
                                                     ".inf",
                                                     "-.inf",
                                                     "nan",
                                                     "2147483647",
                                                     "2147483648",
                                                     "4294967296",
                                                     "9223372036854775807",
                                                     "-9223372036854775808",
                                                     "0x7f",
                                                     "1_000",
                                                     "0.1.2",
                                                     "--1"};

const std::array<std::string, 26> hostile_values = {"",
                                                    "~",
                                                    "[]",
                                                    "{}",
                                                    "[[]]",
                                                    "[1, 2]",
                                                    "[0, 0, 0]",
                                                    "{a: 1}",
                                                    "true",
                                                    "''",
                                                    "\"",
                                                    "text",
                                                    "*alias",
                                                    "&anchor 1",
                                                    "!!binary x",
                                                    "|",
                                                    "? key",
                                                    "- 1",
                                                    "<<: {}",
                                                    "..",
                                                    "/dev/zero",
                                                    "\xc3\xa9\xe4\xb8\xad",
                                                    std::string(1, '\0'),
                                                    "%s%n{0}",
                                                    std::string(100'000, 'a'),
                                                    std::string(5'000, '[')};

template <class Items>
const auto& one_of(const Items& items, Random& random) {
  return items[below(std::size(items), random)];
}

struct Token {
  std::size_t begin, size;
};

/// The longest pieces whose characters belong to numbers and words.
std::vector<Token> tokens(const std::string& text) {
  std::vector<Token> found;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    const bool belongs = std::isalnum(letter) != 0 || letter == '_' || letter == '.' || letter == '+' || letter == '-';
    if (belongs && !inside) {
      found.push_back({i, 0});
    }
    if (belongs) {
      ++found.back().size;
    }
    inside = belongs;
  }
  return found;
}

bool is_number(const std::string& token) {
  return token.find_first_of("0123456789") == 0 || token.find_first_of("+-.") == 0;
}

std::string other_number(const std::string& number, Random& random) {
  const double value = std::strtod(number.c_str(), nullptr);
  switch (below(6, random)) {
    case 0:
      return fmt::format("{:.6g}", value * std::pow(10.0, static_cast<double>(below(24, random)) - 12.0));
    case 1:
      return "-" + number;
    case 2:
    case 3:
    case 4:
      return fmt::format("{}", value * (0.5 + static_cast<double>(below(1000, random)) / 666.0));
    default:
      return one_of(hostile_numbers, random);
  }
}

std::string other_word(const std::string& word, const std::string& text, const std::vector<Token>& all,
                       Random& random) {
  const Token& other = one_of(all, random);
  switch (below(4, random)) {
    case 0:
      return text.substr(other.begin, other.size);
    case 1:
      return word.substr(1);
    case 2:
      return word + "_1";
    default:
      return one_of(hostile_values, random);
  }
}

void change_token(std::string& text, Random& random) {
  const auto all = tokens(text);
  if (all.empty()) {
    return;
  }
  const auto [begin, size] = one_of(all, random);
  const std::string token = text.substr(begin, size);
  text.replace(begin, size, is_number(token) ? other_number(token, random) : other_word(token, text, all, random));
}

/// Replaces what follows a colon, a comma, an equals sign or a bracket.
void change_value(std::string& text, Random& random) {
  constexpr const char* separators = ":,=([{ \n";
  const std::size_t begin = text.find_first_of(separators, text.empty() ? 0 : below(text.size(), random));
  if (begin == std::string::npos) {
    return;
  }
  const std::size_t end = std::min(text.find_first_of(",)]}\n", begin + 1), text.size());
  text.replace(begin + 1, end - begin - 1,
               " " + (below(2, random) == 0 ? one_of(hostile_values, random) : one_of(hostile_numbers, random)));
}

void change_line(std::string& text, Random& random) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  if (lines.empty()) {
    return;
  }
  const auto here = static_cast<std::ptrdiff_t>(below(lines.size(), random));
  const std::size_t there = below(lines.size(), random);
  switch (below(5, random)) {
    case 0:
      lines.erase(lines.begin() + here);
      break;
    case 1:
      lines.insert(lines.begin() + here, std::string(lines[there]));
      break;
    case 2:
      std::swap(lines[here], lines[there]);
      break;
    case 3:
      lines[here].insert(0, below(2, random) == 0 ? "  " : "\t- ");
      break;
    default:
      lines.resize(here);
  }
  text = fmt::format("{}\n", fmt::join(lines, "\n"));
}

/// A place in the bytes; most often not among zeros, of which files have many.
std::size_t place_in(const std::string& bytes, Random& random) {
  std::size_t place = below(bytes.size(), random);
  for (int attempt = 0; attempt < 8 && bytes[place] == 0; ++attempt) {
    place = below(bytes.size(), random);
  }
  return place;
}

}  // namespace

std::string mutated_text(std::string text, Random& random) {
  for (std::size_t changes = 1 + below(3, random) * below(2, random); changes > 0; --changes) {
    switch (below(10, random)) {
      case 0:
        text = mutated_bytes(std::move(text), random);
        break;
      case 1:
        change_line(text, random);
        break;
      case 2:
      case 3:
        change_value(text, random);
        break;
      default:
        change_token(text, random);
    }
  }
  return text;
}

std::string mutated_bytes(std::string bytes, Random& random) {
  if (bytes.empty()) {
    return bytes;
  }
  const std::size_t place = place_in(bytes, random);
  constexpr std::array<std::size_t, 4> lengths = {1, 8, 512, 4096};
  const std::size_t length = std::min(one_of(lengths, random), bytes.size() - place);
  switch (below(8, random)) {
    case 0:
      for (std::size_t i = place; i < place + std::min<std::size_t>(length, 8); ++i) {
        bytes[i] = static_cast<char>(random());
      }
      break;
    case 1:
      bytes.replace(place, length, length, '\0');
      break;
    case 2:
      bytes.replace(place, std::min<std::size_t>(length, 8), std::min<std::size_t>(length, 8), '\xff');
      break;
    case 3:
      bytes.erase(place, length);
      break;
    case 4:
      bytes.insert(place, bytes.substr(place, length));
      break;
    case 5:
      bytes.resize(place);
      break;
    default:
      for (std::size_t flips = std::size_t{1} << below(6, random); flips > 0; --flips) {
        bytes[place_in(bytes, random)] ^= static_cast<char>(1U << below(8, random));
      }
  }
  return bytes;
}

}  // namespace idiophone::mutants
