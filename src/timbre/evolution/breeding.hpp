#pragma once
// Changes of trees by chance.

#include <cstdint>
#include <string>

#include "idiophone/timbre/evolution/evolution.hpp"
#include "idiophone/timbre/language/timbre_tree.hpp"
#include "idiophone/timbre/nodes/random.hpp"

namespace idiophone::timbre {

/// Random numbers one after another.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  [[nodiscard]] double uniform() { return random_.uniform(next_++); }
  [[nodiscard]] double normal() { return random_.normal(next_++); }
  /// From 0 to count - 1.
  [[nodiscard]] std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

 private:
  Random random_;
  std::int64_t next_ = 0;
};

/// Multiplies some numbers by factors near 1: about one in three, at least one.
/// @param spread  standard deviation of the logarithm of a factor
void mutate_constants(Tree& tree, double spread, Dice& dice);

/// Changes the numbers as they differ between two other trees (differential evolution: Storn and Price 1997), so that
/// the steps become as small as the parents are alike. Does nothing if the trees do not have the same numbers of
/// numbers.
void mutate_by_difference(Tree& tree, const Tree& from, const Tree& to, Dice& dice);

/// Puts another node in the place of one: another kind with the same arguments, or one of its own arguments.
void mutate_node(Tree& tree, Dice& dice);

/// Puts a part of the other tree in the place of a part of this one. Names that this tree does not have become a
/// mistake, which valid_sound() finds.
void cross(Tree& tree, const Tree& other, Dice& dice);

/// Numbers, names and lists.
[[nodiscard]] std::size_t size_of(const Tree& tree);

/// Whether the tree can sound: its types agree, and its first samples are finite.
[[nodiscard]] bool is_valid(const Tree& tree, int rate, std::size_t most_nodes);

}  // namespace idiophone::timbre
