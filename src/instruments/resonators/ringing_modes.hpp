#pragma once
// The sound of modes on which no force acts. Their states are kept in double precision and take strides of 16 audio
// samples. The samples of a stride are computed in single precision, which is twice as fast. The rounding is noise at
// about -130 dB of the sound and does not grow with time.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "mode_groups.hpp"

namespace idiophone::resonators {

/// Audio samples from one state to the next.
inline constexpr std::size_t samples_in_stride = 16;

/// A number in single precision for each of twice as many modes as in a ModePack.
using SinglePack = float __attribute__((vector_size(register_size)));

struct SingleGroup {
  std::array<SinglePack, packs_in_group / 2> real, imaginary;
};

/// Sums over modes, [samples x outputs].
template <std::size_t outputs>
using SingleSums = std::array<SinglePack, ResonatorBank::most_samples * outputs>;

/// Both rounded, one after the other.
inline SinglePack to_single(const ModePack& first, const ModePack& second) {
  using Half = float __attribute__((vector_size(register_size / 2)));
  const Half a = __builtin_convertvector(first, Half), b = __builtin_convertvector(second, Half);
  return [&]<std::size_t... lane>(std::index_sequence<lane...>) {
    return __builtin_shufflevector(a, b, static_cast<int>(lane)...);
  }
  (std::make_index_sequence<2 * modes_in_pack>());
}

inline void to_single(const ModeGroup& group, SingleGroup& single) {
  for (std::size_t p = 0; p < single.real.size(); ++p) {
    single.real[p] = to_single(group.real[2 * p], group.real[2 * p + 1]);
    single.imaginary[p] = to_single(group.imaginary[2 * p], group.imaginary[2 * p + 1]);
  }
}

/// What a stride needs of the factors by which modes turn in an audio sample.
struct StrideTurns {
  std::array<SingleGroup, samples_in_stride> powers;  ///< 0 to 15 of each factor
  ModeGroup whole;                                    ///< the power 16

  explicit StrideTurns(const ModeGroup& turn) {
    powers[0].real.fill(SinglePack{} + 1.0F);
    powers[0].imaginary.fill(SinglePack{});
    to_single(turn, powers[1]);
    multiply(whole, turn, turn);
    for (std::size_t known = 2; known < samples_in_stride; known *= 2) {
      SingleGroup factor;
      to_single(whole, factor);
      for (std::size_t power = 0; power < known; ++power) {
        multiply(powers[known + power], powers[power], factor);
      }
      multiply(whole, whole, whole);
    }
  }
};

/// Adds the sound of one group.
/// @param kept     state `offset` audio samples before the first one; afterwards that of the last stride's beginning
/// @param offset   below samples_in_stride
/// @param samples  at most ResonatorBank::most_samples
template <std::size_t outputs>
void ring_group(ModeGroup& kept, const ModeGroup& turn, const GroupGains<outputs>& gains, std::size_t offset,
                std::size_t samples, SingleSums<outputs>& sums) {
  const StrideTurns turns(turn);
  std::array<SingleGroup, outputs> gain;
  for (std::size_t o = 0; o < outputs; ++o) {
    to_single(*gains[o], gain[o]);
  }
  ModeGroup state = kept;
  for (std::size_t first = 0; first < samples; offset = 0) {
    SingleGroup z;
    to_single(state, z);
    std::array<SingleGroup, outputs> heard;
    for (std::size_t o = 0; o < outputs; ++o) {
      multiply(heard[o], gain[o], z);
    }
    const std::size_t count = std::min(samples_in_stride - offset, samples - first);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t o = 0; o < outputs; ++o) {
        SinglePack& sum = sums[(first + i) * outputs + o];
        sum = with_sound(sum, heard[o], turns.powers[offset + i]);
      }
    }
    if (offset + count == samples_in_stride) {
      multiply(state, state, turns.whole);
    }
    first += count;
  }
  kept = state;
}

}  // namespace idiophone::resonators
