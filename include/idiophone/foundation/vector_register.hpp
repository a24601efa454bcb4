#pragma once
// Numbers that fill a vector register, as the processor computes them at once.

#include <cstddef>

namespace idiophone {

/// Bytes of the processor's vector registers: GCC computes with wider vectors several times as slowly.
#if defined(__AVX512F__)
inline constexpr std::size_t register_size = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_size = 32;
#else
inline constexpr std::size_t register_size = 16;
#endif

/// In double precision, one lane after another.
template <class Pack>
inline double sum_of_lanes(const Pack& lanes) {
  double sum = 0.0;
  for (std::size_t lane = 0; lane < sizeof(Pack) / sizeof(lanes[0]); ++lane) {
    sum += static_cast<double>(lanes[lane]);
  }
  return sum;
}

/// The same sum, but one half of the lanes is added to the other until one is left: less exact in its order, and faster
/// where several sums are computed at once. [4, 8 or 16 lanes]
template <class Pack>
inline double pairwise_sum_of_lanes(const Pack& lanes) {
  using Doubles4 = double __attribute__((vector_size(4 * sizeof(double))));
  using Doubles8 = double __attribute__((vector_size(8 * sizeof(double))));
  constexpr std::size_t count = sizeof(Pack) / sizeof(lanes[0]);
  if constexpr (count == 16) {
    return pairwise_sum_of_lanes(
        __builtin_convertvector(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3, 4, 5, 6, 7), Doubles8) +
        __builtin_convertvector(__builtin_shufflevector(lanes, lanes, 8, 9, 10, 11, 12, 13, 14, 15), Doubles8));
  } else if constexpr (count == 8) {
    return pairwise_sum_of_lanes(__builtin_convertvector(__builtin_shufflevector(lanes, lanes, 0, 1, 2, 3), Doubles4) +
                                 __builtin_convertvector(__builtin_shufflevector(lanes, lanes, 4, 5, 6, 7), Doubles4));
  } else {
    static_assert(count == 4);
    return (static_cast<double>(lanes[0]) + static_cast<double>(lanes[2])) +
           (static_cast<double>(lanes[1]) + static_cast<double>(lanes[3]));
  }
}

}  // namespace idiophone
