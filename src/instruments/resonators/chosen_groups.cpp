// Which groups of modes are heard.

#include <algorithm>

#include "idiophone/instruments/resonators/resonator_bank.hpp"
#include "mode_groups.hpp"

namespace idiophone::resonators {

namespace {

/// The state after any number of samples, by squares of the factor.
ModeGroup advanced(ModeGroup state, ModeGroup turn, std::size_t samples) {
  for (; samples > 0; samples /= 2) {
    if (samples % 2 == 1) {
      multiply(state, state, turn);
    }
    multiply(turn, turn, turn);
  }
  return state;
}

}  // namespace

void ResonatorBank::choose(std::span<const char> heard, std::size_t fade) {
  catch_up();
  silence_modes();
  has_choice_ = false;
  for (std::size_t group = 0; group < groups(); ++group) {
    const bool was_heard = hears(group);
    parts_[group] =
        heard[group] != 0 ? (was_heard ? Part::heard : Part::returns) : (was_heard ? Part::leaves : Part::unheard);
    has_choice_ |= parts_[group] != Part::heard;
  }
  fade_ = fade;
  faded_ = 0;
}

void ResonatorBank::hear_all() {
  if (!has_choice_) {
    return;
  }
  catch_up();
  for (std::size_t group = 0; group < groups(); ++group) {
    const double weight = weight_of(parts_[group], 0);
    for (std::size_t p = 0; p < packs_in_group && weight < 1.0; ++p) {
      states_[group].real[p] *= weight;
      states_[group].imaginary[p] *= weight;
    }
    parts_[group] = Part::heard;
  }
  has_choice_ = false;
}

double ResonatorBank::weight_of(Part part, std::size_t sample) const {
  if (part == Part::heard || part == Part::unheard) {
    return part == Part::heard ? 1.0 : 0.0;
  }
  const double done = std::min(1.0, static_cast<double>(faded_ + sample) / static_cast<double>(fade_));
  return part == Part::returns ? done : 1.0 - done;
}

void ResonatorBank::rest(std::size_t samples) {
  unheard_ += samples;
  faded_ += samples;
}

bool ResonatorBank::is_heard() const {
  for (std::size_t group = 0; group < groups(); ++group) {
    if (moving_[group] != 0 && parts_[group] != Part::unheard) {
      return true;
    }
  }
  return false;
}

void ResonatorBank::catch_up() {
  for (std::size_t group = 0; group < groups(); ++group) {
    states_[group] = present(group);
  }
  behind_ = 0;
  unheard_ = 0;
}

ModeGroup ResonatorBank::present(std::size_t group) const {
  ModeGroup state = states_[group];
  if (moving_[group] == 0) {
    return state;
  }
  if (parts_[group] == Part::unheard) {
    return advanced(state, turns_[group], unheard_);
  }
  for (std::size_t i = 0; i < behind_; ++i) {
    multiply(state, state, turns_[group]);
  }
  return state;
}

}  // namespace idiophone::resonators
