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

}  // namespace idiophone
