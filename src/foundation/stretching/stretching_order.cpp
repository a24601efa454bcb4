#include "stretching_order.hpp"

#include <algorithm>
#include <numeric>

namespace idiophone::stretching {

namespace {

using Flags = std::vector<char>;

std::vector<ModePair> all_pairs(std::size_t modes) {
  std::vector<ModePair> pairs;
  for (std::uint32_t i = 0; i < modes; ++i) {
    for (std::uint32_t j = i; j < modes; ++j) {
      pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// How many pairs two terms both have, over those that any of them has.
double likeness(const Flags& one, const Flags& other) {
  std::size_t both = 0, any = 0;
  for (std::size_t pair = 0; pair < one.size(); ++pair) {
    both += one[pair] & other[pair];
    any += one[pair] | other[pair];
  }
  return any > 0 ? static_cast<double>(both) / static_cast<double>(any) : 0.0;
}

/// Each term is followed by that which is most like those of its block so far.
/// @param has  [terms x pairs]
std::vector<std::size_t> chain(const std::vector<Flags>& has, std::size_t terms_at_once) {
  std::vector<std::size_t> order, left(has.size());
  std::iota(left.begin(), left.end(), 0);
  Flags of_block(has.front().size());
  while (!left.empty()) {
    const auto next = std::ranges::max_element(
        left, {}, [&](std::size_t term) { return order.empty() ? 0.0 : likeness(of_block, has[term]); });
    if (order.size() % terms_at_once == 0) {
      std::ranges::fill(of_block, 0);
    }
    std::ranges::transform(of_block, has[*next], of_block.begin(), std::bit_or());
    order.push_back(*next);
    left.erase(next);
  }
  return order;
}

}  // namespace

StretchingOrder stretching_order(std::span<const double> quadratic, std::size_t terms, std::size_t modes,
                                 std::size_t terms_at_once) {
  const std::vector<ModePair> pairs = all_pairs(modes);
  std::vector<Flags> has(terms, Flags(pairs.size()));
  for (std::size_t term = 0; term < terms; ++term) {
    std::ranges::transform(pairs, has[term].begin(), [&](const ModePair& pair) {
      return static_cast<char>(quadratic[(term * modes + pair.first) * modes + pair.second] != 0.0);
    });
  }
  StretchingOrder order{.terms = chain(has, terms_at_once), .pairs = {}};
  std::vector<Flags> blocks(pairs.size(), Flags((terms + terms_at_once - 1) / terms_at_once));  // that have a pair
  for (std::size_t place = 0; place < terms; ++place) {
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
      blocks[pair][place / terms_at_once] |= has[order.terms[place]][pair];
    }
  }
  std::vector<std::size_t> sorted(pairs.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::ranges::stable_sort(sorted, std::ranges::greater(),
                           [&](std::size_t pair) -> const Flags& { return blocks[pair]; });
  for (const std::size_t pair : sorted) {
    if (std::ranges::find(blocks[pair], 1) != blocks[pair].end()) {
      order.pairs.push_back(pairs[pair]);
    }
  }
  return order;
}

}  // namespace idiophone::stretching
