#include "idiophone/instruments/resonators/resonator_bank.hpp"

#include <algorithm>
#include <cassert>

namespace idiophone::resonators {

namespace {

/// One group in one block.
template <std::size_t outputs>
struct GroupGains {
  std::array<const ModeGroup*, outputs> at;
};

/// Sums of eight lanes each, [samples x outputs].
template <std::size_t outputs>
using LaneSums = std::array<ModePack, ResonatorBank::most_samples * outputs>;

/// A call would put the state into memory, which costs a quarter of the time of `play`.
[[gnu::always_inline]] inline void drive(ModeGroup& state, const Drive& drive, std::size_t group, std::size_t sample) {
  const ForcePiece piece = drive.force[sample];
  const ModeGroup& mean = drive.by_mean[group];
  const ModeGroup& slope = drive.by_slope[group];
  for (std::size_t p = 0; p < packs_in_group; ++p) {
    state.real[p] += piece.mean * mean.real[p] + piece.slope * slope.real[p];
    state.imaginary[p] += piece.mean * mean.imaginary[p] + piece.slope * slope.imaginary[p];
  }
}

/// The state is a local copy so that it stays in registers.
template <std::size_t outputs>
void advance_group(ModeGroup& kept, const ModeGroup& turn, const GroupGains<outputs>& gains,
                   std::span<const Drive> drives, std::size_t group, std::size_t samples, LaneSums<outputs>& sums) {
  ModeGroup z = kept;
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t o = 0; o < outputs; ++o) {
      const ModeGroup& gain = *gains.at[o];
      ModePack sum = sums[i * outputs + o];
      for (std::size_t p = 0; p < packs_in_group; ++p) {
        sum += gain.real[p] * z.real[p] - gain.imaginary[p] * z.imaginary[p];
      }
      sums[i * outputs + o] = sum;
    }
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      const ModePack real = z.real[p];
      z.real[p] = turn.real[p] * real - turn.imaginary[p] * z.imaginary[p];
      z.imaginary[p] = turn.real[p] * z.imaginary[p] + turn.imaginary[p] * real;
    }
    for (const Drive& one : drives) {
      if (one.acts) {
        drive(z, one, group, i);
      }
    }
  }
  kept = z;
}

double sum_of_lanes(const ModePack& lanes) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

/// A complex number for each of eight modes.
struct ComplexPack {
  ModePack real, imaginary;
};

ComplexPack quotient(const ComplexPack& a, const ComplexPack& b) {
  const ModePack square = b.real * b.real + b.imaginary * b.imaginary;
  return {(a.real * b.real + a.imaginary * b.imaginary) / square,
          (a.imaginary * b.real - a.real * b.imaginary) / square};
}

/// What each output would get of modes that follow a force of 1, and one that rises by 1 in a sample.
template <std::size_t outputs>
struct FollowingSound {
  std::array<ModePack, outputs> of_force{}, of_rise{};
};

/// In the steady state z(n) = a F(n) + b of a force that rises by 1 in each sample, z(n + 1) = turn z(n) + by_mean mean
/// + by_slope slope gives a (1 - turn) = by_mean and b (1 - turn) = (by_mean + by_slope)/2 - a.
template <std::size_t outputs>
FollowingSound<outputs> following_sound(const Drive& drive, std::span<const ModeGroup> turns,
                                        std::span<const ModeGroup> gains) {
  FollowingSound<outputs> sums;
  for (std::size_t group = 0; group < turns.size(); ++group) {
    const ModeGroup &mean = drive.by_mean[group], &slope = drive.by_slope[group];
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      const ComplexPack rest{1.0 - turns[group].real[p], -turns[group].imaginary[p]};
      const ComplexPack a = quotient({mean.real[p], mean.imaginary[p]}, rest);
      const ComplexPack b = quotient(
          {0.5 * (mean.real[p] + slope.real[p]) - a.real, 0.5 * (mean.imaginary[p] + slope.imaginary[p]) - a.imaginary},
          rest);
      for (std::size_t o = 0; o < outputs; ++o) {
        const ModeGroup& gain = gains[o * turns.size() + group];
        sums.of_force[o] += gain.real[p] * a.real - gain.imaginary[p] * a.imaginary;
        sums.of_rise[o] += gain.real[p] * b.real - gain.imaginary[p] * b.imaginary;
      }
    }
  }
  return sums;
}

/// Takes away what the modes do when they only follow a force.
template <std::size_t outputs>
void take_following_sound(const Drive& drive, std::span<const ModeGroup> turns, std::span<const ModeGroup> gains,
                          std::span<double> sound) {
  const FollowingSound<outputs> sums = following_sound<outputs>(drive, turns, gains);
  for (std::size_t o = 0; o < outputs; ++o) {
    const double of_force = sum_of_lanes(sums.of_force[o]), of_rise = sum_of_lanes(sums.of_rise[o]);
    for (std::size_t i = 0; i < drive.force.size(); ++i) {
      sound[i * outputs + o] -= drive.force[i].begin * of_force + drive.force[i].rise * of_rise;
    }
  }
}

}  // namespace

std::vector<ModeGroup> in_groups(std::span<const Complex> values) {
  std::vector<ModeGroup> groups((values.size() + modes_in_group - 1) / modes_in_group);
  for (std::size_t mode = 0; mode < values.size(); ++mode) {
    ModeGroup& group = groups[mode / modes_in_group];
    const std::size_t pack = mode % modes_in_group / pack_size;
    group.real[pack][mode % pack_size] = values[mode].real();
    group.imaginary[pack][mode % pack_size] = values[mode].imag();
  }
  return groups;
}

ResonatorBank::ResonatorBank(std::span<const Complex> turns)
    : turns_(in_groups(turns)), states_(turns_.size()), moving_(turns_.size(), 0) {}

void ResonatorBank::retune(std::span<const ModeGroup> turns) {
  std::ranges::copy(turns.first(turns_.size()), turns_.begin());
}

void ResonatorBank::advance(std::span<const Drive> drives, std::span<const ModeGroup> gains, std::size_t outputs,
                            std::span<double> sound) {
  switch (outputs) {
    case 1:
      return advance_all<1>(drives, gains, sound);
    case 2:
      return advance_all<2>(drives, gains, sound);
    case 4:
      return advance_all<4>(drives, gains, sound);
    case 8:
      return advance_all<8>(drives, gains, sound);
    default:
      assert(!"1, 2, 4 or 8 outputs");
  }
}

template <std::size_t outputs>
void ResonatorBank::advance_all(std::span<const Drive> drives, std::span<const ModeGroup> gains,
                                std::span<double> sound) {
  const std::size_t samples = sound.size() / outputs;
  LaneSums<outputs> sums;
  std::fill_n(sums.begin(), sound.size(), ModePack{});
  for (std::size_t group = 0; group < turns_.size(); ++group) {
    if (!drives.empty()) {
      moving_[group] = 1;
    }
    if (moving_[group] == 0) {
      continue;
    }
    GroupGains<outputs> of_group;
    for (std::size_t o = 0; o < outputs; ++o) {
      of_group.at[o] = &gains[o * turns_.size() + group];
    }
    advance_group<outputs>(states_[group], turns_[group], of_group, drives, group, samples, sums);
  }
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sound[i] = sum_of_lanes(sums[i]);
  }
  for (const Drive& one : drives) {
    take_following_sound<outputs>(one, turns_, gains, sound);
  }
}

void ResonatorBank::silence() {
  constexpr double inaudible = 1e-40;  // (m sqrt(kg)/s)^2
  for (std::size_t group = 0; group < states_.size(); ++group) {
    ModePack energy{};
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      energy +=
          states_[group].real[p] * states_[group].real[p] + states_[group].imaginary[p] * states_[group].imaginary[p];
    }
    if (moving_[group] != 0 && sum_of_lanes(energy) < inaudible) {
      states_[group] = {};
      moving_[group] = 0;
    }
  }
}

bool ResonatorBank::sounds() const {
  return std::ranges::find(moving_, 1) != moving_.end();
}

Complex ResonatorBank::state(std::size_t mode) const {
  const ModeGroup& group = states_[mode / modes_in_group];
  const std::size_t pack = mode % modes_in_group / pack_size;
  return {group.real[pack][mode % pack_size], group.imaginary[pack][mode % pack_size]};
}

}  // namespace idiophone::resonators
