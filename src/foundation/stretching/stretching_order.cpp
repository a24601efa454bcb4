#include "stretching_order.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace idiophone::stretching {

namespace {

/// What a term or a pair has, a bit for each.
class Flags {
 public:
  explicit Flags(std::size_t count) : words_((count + bits - 1) / bits) {}
  void set(std::size_t place) { words_[place / bits] |= std::uint64_t{1} << (bits - 1 - place % bits); }
  [[nodiscard]] bool any() const {
    return std::ranges::any_of(words_, [](std::uint64_t word) { return word != 0; });
  }
  void add(const Flags& other) { std::ranges::transform(words_, other.words_, words_.begin(), std::bit_or()); }

  /// Whether it has the first place that only one of them has.
  [[nodiscard]] bool is_before(const Flags& other) const { return words_ > other.words_; }

  /// How many both have, and how many any of them has.
  struct Likeness {
    std::int64_t both = 0, any = 0;
    /// Whether both/any is.
    [[nodiscard]] bool is_above(const Likeness& other) const { return both * other.any > other.both * any; }
  };
  [[nodiscard]] Likeness likeness(const Flags& other) const {
    Likeness likeness;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      likeness.both += std::popcount(words_[i] & other.words_[i]);
      likeness.any += std::popcount(words_[i] | other.words_[i]);
    }
    return likeness;
  }

 private:
  static constexpr std::size_t bits = 64;
  std::vector<std::uint64_t> words_;
};

std::vector<ModePair> all_pairs(std::size_t modes) {
  std::vector<ModePair> pairs;
  for (std::uint32_t i = 0; i < modes; ++i) {
    for (std::uint32_t j = i; j < modes; ++j) {
      pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Which of some terms or pairs is most like what a block has; the first where none is.
std::size_t most_like(const Flags& of_block, const std::vector<Flags>& has, std::span<const std::size_t> some) {
  std::size_t best = 0;
  Flags::Likeness most{.both = 0, .any = 1};
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (const Flags::Likeness likeness = of_block.likeness(has[some[i]]); likeness.is_above(most)) {
      best = i;
      most = likeness;
    }
  }
  return best;
}

/// Each term or pair is followed by that of the next 1024 left which is most like those of its block so far.
/// @param has   [terms or pairs]
/// @param left  their numbers
std::vector<std::size_t> chain(const std::vector<Flags>& has, const std::vector<std::size_t>& left,
                               std::size_t at_once) {
  constexpr std::size_t compared = 1024;
  std::vector<std::size_t> order;
  std::size_t taken = std::min(compared, left.size());
  std::vector<std::size_t> next_ones(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(taken));
  Flags of_block = has.front();
  while (!next_ones.empty()) {
    const auto next = next_ones.begin() + static_cast<std::ptrdiff_t>(most_like(of_block, has, next_ones));
    if (order.size() % at_once == 0) {
      of_block = has[*next];
    } else {
      of_block.add(has[*next]);
    }
    order.push_back(*next);
    next_ones.erase(next);
    if (taken < left.size()) {
      next_ones.push_back(left[taken++]);
    }
  }
  return order;
}

std::vector<std::size_t> numbers_below(std::size_t end) {
  std::vector<std::size_t> numbers(end);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace

StretchingOrder stretching_order(std::span<const double> quadratic, std::size_t terms, std::size_t modes,
                                 const BlockSize& block) {
  const std::vector<ModePair> pairs = all_pairs(modes);
  const auto has = [&](std::size_t term, std::size_t pair) {
    return quadratic[(term * modes + pairs[pair].first) * modes + pairs[pair].second] != 0.0;
  };
  std::vector<Flags> of_terms(terms, Flags(pairs.size()));
  for (std::size_t term = 0; term < terms; ++term) {
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
      if (has(term, pair)) {
        of_terms[term].set(pair);
      }
    }
  }
  StretchingOrder order{.terms = chain(of_terms, numbers_below(terms), block.terms), .pairs = {}};
  std::vector<Flags> of_pairs(pairs.size(), Flags((terms + block.terms - 1) / block.terms));  // blocks of terms
  for (std::size_t place = 0; place < terms; ++place) {
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
      if (has(order.terms[place], pair)) {
        of_pairs[pair].set(place / block.terms);
      }
    }
  }
  std::vector<std::size_t> used = numbers_below(pairs.size());
  std::erase_if(used, [&](std::size_t pair) { return !of_pairs[pair].any(); });
  std::ranges::stable_sort(used, [&](std::size_t a, std::size_t b) { return of_pairs[a].is_before(of_pairs[b]); });
  std::ranges::transform(chain(of_pairs, used, block.pairs), std::back_inserter(order.pairs),
                         [&](std::size_t pair) { return pairs[pair]; });
  return order;
}

}  // namespace idiophone::stretching
