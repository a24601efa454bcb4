#include "stretching_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace idiophone::stretching {
namespace {

constexpr std::size_t modes = 24, terms = 24;
constexpr BlockSize block{.terms = 4, .pairs = 16};

/// Each four terms have most pairs of three of six kinds, and few others. As quadratic of StretchingEnergy.
std::vector<double> some_kinds() {
  std::vector<double> quadratic(terms * modes * modes);
  unsigned random = 1;
  for (std::size_t group = 0; group < terms / 4; ++group) {
    for (std::size_t i = 0; i < modes; ++i) {
      for (std::size_t j = i; j < modes; ++j) {
        random = random * 1664525U + 1013904223U;
        const bool is_own = (5 * i + 3 * j + group) % 6 < 3;
        const bool has = (random >> 16U) % 100 < (is_own ? 75 : 5);
        for (std::size_t term = group; term < terms; term += terms / 4) {  // those of a group are far apart
          quadratic[(term * modes + i) * modes + j] = quadratic[(term * modes + j) * modes + i] = has ? 1.0 : 0.0;
        }
      }
    }
  }
  return quadratic;
}

TEST(StretchingOrder, NeighboursBelongTogether) {
  const std::vector<double> quadratic = some_kinds();
  const StretchingOrder order = stretching_order(quadratic, terms, modes, block);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& [first, second] : order.pairs) {
    pairs.emplace(first, second);
  }
  EXPECT_EQ(pairs.size(), order.pairs.size());
  EXPECT_EQ(std::set<std::size_t>(order.terms.begin(), order.terms.end()).size(), terms);
  std::size_t blocks = 0, pairs_of_terms = 0;
  for (std::size_t term = 0; term < terms; term += block.terms) {
    for (std::size_t pair = 0; pair < order.pairs.size(); pair += block.pairs) {
      std::size_t here = 0;
      for (std::size_t t = term; t < term + block.terms; ++t) {
        for (std::size_t p = pair; p < std::min(pair + block.pairs, order.pairs.size()); ++p) {
          const auto [i, j] = order.pairs[p];
          here += quadratic[(order.terms[t] * modes + i) * modes + j] != 0.0 ? 1 : 0;
        }
      }
      blocks += here > 0 ? 1 : 0;
      pairs_of_terms += here;
    }
  }
  std::size_t all = 0;
  for (std::size_t n = 0; n < quadratic.size(); ++n) {
    all += n / modes % modes <= n % modes && quadratic[n] != 0.0 ? 1 : 0;
  }
  EXPECT_EQ(pairs_of_terms, all) << "none is lost";
  EXPECT_LE(blocks, 65U);  // of 114
}

}  // namespace
}  // namespace idiophone::stretching
