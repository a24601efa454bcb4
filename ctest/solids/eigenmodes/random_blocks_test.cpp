// Estimated errors of frequencies of random bodies: of how many modes they are right (docs/method/modes.md).

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "long_verification.hpp"
#include "random_block.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

/// Of how many modes an estimate is right.
struct Shares {
  int modes = 0;
  int at_most_twice = 0;     ///< the true error is at most twice the estimate
  int at_least_a_fifth = 0;  ///< the true error is at least a fifth of it

  void add(const Judged& mode) {
    constexpr double unheard = 0.3;  // cents
    const double error = std::abs(mode.error);
    const double estimate = std::abs(mode.estimate);
    ++modes;
    at_most_twice += error <= 2 * estimate + unheard ? 1 : 0;
    at_least_a_fifth += error >= 0.2 * estimate - unheard ? 1 : 0;
  }
  [[nodiscard]] double upper() const { return double(at_most_twice) / modes; }
  [[nodiscard]] double lower() const { return double(at_least_a_fifth) / modes; }
};

/// Name of an element type with its orders.
std::string name_of(element::Type type) {
  const auto [plane, thickness] = element::orders(type);
  return element::has_choice_of_orders(type) ? fmt::format("hex {},{}", plane, thickness)
                                             : std::string(element::name(type));
}

/// How many bodies are drawn: many for the long verification.
unsigned number_of_blocks() {
  return support::long_verification() ? 200 : 4;
}

ON_RANKS(1);

TEST(RandomBlocks, MostEstimatesAreRight) {
  std::map<std::string, Shares> by_element;
  Shares all;
  for (unsigned seed = 1; seed <= number_of_blocks(); ++seed) {
    const RandomBlock block = RandomBlocks(seed).draw();
    const ExactModes exact(block.shape, 14);
    const std::string element = name_of(block.type);
    for (const Judged& mode : judged(block.shape, exact, block.type, block.cells, 6, block.mass)) {
      all.add(mode);
      by_element[element].add(mode);
      fmt::print("{:>4}  {:<6}  {:<8}  {:>9.1f} Hz  estimate {:>+8.2f}  error {:>+8.2f}\n", seed, block.shape.name,
                 element, mode.frequency, mode.estimate, mode.error);
    }
  }
  fmt::print("{:<8}  {:>5}  {:>13}  {:>16}\n", "element", "modes", "at most twice", "at least a fifth");
  by_element["all"] = all;
  for (const auto& [element, shares] : by_element) {
    fmt::print("{:<8}  {:>5}  {:>12.1f}%  {:>15.1f}%\n", element, shares.modes, 100 * shares.upper(),
               100 * shares.lower());
  }
  EXPECT_GE(all.modes, 5 * number_of_blocks());
  EXPECT_GE(all.upper(), 0.95);
  EXPECT_GE(all.lower(), 0.8);
}

}  // namespace
}  // namespace idiophone::eigenmodes
