#pragma once
// Texts and bytes with random damage; scripts/library/robustness/mutations.py makes the same for the whole program.

#include <random>
#include <string>

namespace idiophone::mutants {

using Random = std::mt19937_64;

/// A whole number from 0 to before `end`. The same on every machine.
inline std::size_t below(std::size_t end, Random& random) {
  return random() % end;
}

/// One to three changes of numbers, words, values, lines or bytes.
[[nodiscard]] std::string mutated_text(std::string text, Random& random);

/// Bits flipped, bytes overwritten, set to zero, cut out or repeated, or the end cut off.
[[nodiscard]] std::string mutated_bytes(std::string bytes, Random& random);

}  // namespace idiophone::mutants
