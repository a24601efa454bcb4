#include "idiophone/instruments/resonators/resonator_bank.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "following_sound.hpp"
#include "mode_groups.hpp"
#include "ringing_modes.hpp"

namespace idiophone::resonators {

namespace {

/// Sums over modes, [samples x outputs].
template <std::size_t outputs>
using LaneSums = std::array<ModePack, ResonatorBank::most_samples * outputs>;

/// Adds the sound of one group on which forces act. The state is a local copy so that it stays in registers.
template <std::size_t outputs>
void drive_group(ModeGroup& kept, const ModeGroup& turn, const GroupGains<outputs>& gains,
                 std::span<const Drive> drives, std::size_t group, std::size_t samples, LaneSums<outputs>& sums) {
  ModeGroup z = kept;
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t o = 0; o < outputs; ++o) {
      sums[i * outputs + o] = with_sound(sums[i * outputs + o], *gains[o], z);
    }
    multiply(z, z, turn);
    for (const Drive& one : drives) {
      if (one.acts) {
        drive(z, one, group, i);
      }
    }
  }
  kept = z;
}

}  // namespace

std::vector<ModeGroup> in_groups(std::span<const Complex> values) {
  std::vector<ModeGroup> groups((values.size() + modes_in_group - 1) / modes_in_group);
  for (std::size_t mode = 0; mode < values.size(); ++mode) {
    ModeGroup& group = groups[mode / modes_in_group];
    const std::size_t pack = mode % modes_in_group / modes_in_pack;
    group.real[pack][mode % modes_in_pack] = values[mode].real();
    group.imaginary[pack][mode % modes_in_pack] = values[mode].imag();
  }
  return groups;
}

ResonatorBank::ResonatorBank(std::span<const Complex> turns, std::optional<StretchedModes> stretching)
    : turns_(in_groups(turns)),
      states_(turns_.size()),
      moving_(turns_.size(), 0),
      parts_(turns_.size(), Part::heard),
      stretching_(std::move(stretching)),
      before_(stretching_ ? turns_.size() : 0) {}

void ResonatorBank::retune(std::span<const ModeGroup> turns, double size) {
  catch_up();
  std::ranges::copy(turns.first(turns_.size()), turns_.begin());
  if (stretching_) {
    stretching_->retune(turns_, size);
  }
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
  if (!drives.empty()) {
    hear_all();
  }
  if (std::ranges::any_of(drives, &Drive::acts)) {
    drive_all<outputs>(drives, gains, sound);
  } else {
    ring_all<outputs>(gains, sound);
  }
  for (const Drive& one : drives) {
    take_following_sound<outputs>(one, turns_, gains, sound);
  }
}

template <std::size_t outputs>
void ResonatorBank::drive_all(std::span<const Drive> drives, std::span<const ModeGroup> gains,
                              std::span<double> sound) {
  catch_up();
  std::ranges::fill(moving_, 1);
  LaneSums<outputs> sums;
  std::fill_n(sums.begin(), sound.size(), ModePack{});
  for (std::size_t group = 0; group < groups(); ++group) {
    drive_group<outputs>(states_[group], turns_[group], gains_of<outputs>(group, groups(), gains), drives, group,
                         sound.size() / outputs, sums);
  }
  std::transform(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(sound.size()), sound.begin(),
                 sum_of_lanes<ModePack>);
}

template <std::size_t outputs>
void ResonatorBank::ring_all(std::span<const ModeGroup> gains, std::span<double> sound) {
  std::ranges::fill(sound, 0.0);
  add_ringing<outputs>(Part::heard, gains, sound);
  if (has_choice_) {
    add_ringing<outputs>(Part::returns, gains, sound);
    add_ringing<outputs>(Part::leaves, gains, sound);
  }
  const std::size_t samples = sound.size() / outputs;
  behind_ = (behind_ + samples) % samples_in_stride;
  rest(samples);
}

template <std::size_t outputs>
void ResonatorBank::add_ringing(Part part, std::span<const ModeGroup> gains, std::span<double> sound) {
  constexpr std::size_t groups_in_sum = 64;  // in single precision; the rounding of more would be heard sooner
  const std::size_t samples = sound.size() / outputs;
  SingleSums<outputs> sums;
  for (std::size_t first = 0; first < groups(); first += groups_in_sum) {
    bool is_empty = true;
    for (std::size_t group = first; group < std::min(first + groups_in_sum, groups()); ++group) {
      if (moving_[group] == 0 || parts_[group] != part) {
        continue;
      }
      if (std::exchange(is_empty, false)) {
        std::fill_n(sums.begin(), sound.size(), SinglePack{});
      }
      ring_group<outputs>(states_[group], turns_[group], gains_of<outputs>(group, groups(), gains), behind_, samples,
                          sums);
    }
    for (std::size_t i = 0; i < sound.size() && !is_empty; ++i) {
      sound[i] += weight_of(part, i / outputs) * sum_of_lanes(sums[i]);
    }
  }
}

void ResonatorBank::silence() {
  if (stretching_) {
    stretching_->rest_if_small();
  }
  silence_modes();
}

void ResonatorBank::silence_modes() {
  constexpr double inaudible = 1e-40;  // (m sqrt(kg)/s)^2
  for (std::size_t group = 0; group < groups(); ++group) {
    const bool is_old = parts_[group] == Part::unheard && unheard_ > 0;  // the state is of a sample before
    if (moving_[group] == 0 || is_old) {
      continue;
    }
    ModePack left{};  // energy of the modes that go on
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      ModePack &real = states_[group].real[p], &imaginary = states_[group].imaginary[p];
      const ModePack energy = real * real + imaginary * imaginary;
      real = energy < inaudible ? ModePack{} : real;
      imaginary = energy < inaudible ? ModePack{} : imaginary;
      left += energy < inaudible ? ModePack{} : energy;
    }
    moving_[group] = sum_of_lanes(left) > 0.0 ? 1 : 0;
  }
}

bool ResonatorBank::sounds() const {
  return std::ranges::find(moving_, 1) != moving_.end();
}

Complex ResonatorBank::state(std::size_t mode) const {
  return value_of(present(mode / modes_in_group), mode);
}

Complex value_of(const ModeGroup& group, std::size_t mode) {
  const std::size_t pack = mode % modes_in_group / modes_in_pack;
  return {group.real[pack][mode % modes_in_pack], group.imaginary[pack][mode % modes_in_pack]};
}

}  // namespace idiophone::resonators
