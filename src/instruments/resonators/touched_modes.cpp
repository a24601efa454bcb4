// Modes of a body while contacts act that feel it.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "following_sound.hpp"
#include "idiophone/instruments/resonators/contact.hpp"
#include "mode_groups.hpp"

namespace idiophone::resonators {

namespace {

/// What a sample adds up over the groups.
template <std::size_t outputs>
struct SampleSums {
  std::array<ModePack, outputs> heard{};
  std::array<ModePack, PointContacts::most> ways{};  ///< of the points of contact
};

/// Takes one group through a sample, in which contacts have no force yet.
void advance_free(ModeGroup& z, const ModeGroup& turn, std::span<const Drive> drives, std::size_t group,
                  std::size_t sample) {
  multiply(z, z, turn);
  for (const Drive& one : drives) {
    if (one.acts) {
      drive(z, one, group, sample);
    }
  }
}

ModeGroup change(const ModeGroup& after, const ModeGroup& before) {
  ModeGroup difference;
  for (std::size_t p = 0; p < packs_in_group; ++p) {
    difference.real[p] = after.real[p] - before.real[p];
    difference.imaginary[p] = after.imaginary[p] - before.imaginary[p];
  }
  return difference;
}

void add_force(std::span<ModeGroup> states, const ContactPoint& point, double force) {
  for (std::size_t group = 0; group < states.size(); ++group) {
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      states[group].real[p] += force * point.by_mean[group].real[p];
      states[group].imaginary[p] += force * point.by_mean[group].imaginary[p];
    }
  }
}

}  // namespace

void ResonatorBank::advance(std::span<const Drive> drives, PointContacts& contacts, std::span<const ModeGroup> gains,
                            std::size_t outputs, std::span<double> sound) {
  switch (outputs) {
    case 1:
      return touch_all<1>(drives, contacts, gains, sound);
    case 2:
      return touch_all<2>(drives, contacts, gains, sound);
    case 4:
      return touch_all<4>(drives, contacts, gains, sound);
    case 8:
      return touch_all<8>(drives, contacts, gains, sound);
    default:
      assert(!"1, 2, 4 or 8 outputs");
  }
}

bool ResonatorBank::stretches(std::span<const Drive> drives) const {
  return stretching_ && (stretching_->acts() || std::ranges::any_of(drives, &Drive::acts));
}

std::size_t ResonatorBank::stretching_operations() const {
  return stretching_ ? stretching_->operations() : 0;
}

/// Adds the forces of stretching and of contacts, which feel each other through the modes.
/// @param free  way of each point of contact without both, m
void ResonatorBank::add_forces(PointContacts& contacts, std::span<double> free, std::size_t sample) {
  std::array<double, PointContacts::most> yields{};
  if (stretching_) {
    stretching_->find_force(before_, states_);
    for (std::size_t touch = 0; touch < contacts.count(); ++touch) {
      ModePack pulled{};
      for (std::size_t group = 0; group < groups(); ++group) {
        pulled = with_sound(pulled, contacts.point(touch).displacement[group], stretching_->pull()[group]);
      }
      const double way = sum_of_lanes(pulled);
      free[touch] -= stretching_->free_root() * way;
      yields[touch] = std::sqrt(stretching_->rise()) * way;
    }
  }
  const std::span<const double> forces = contacts.advance(free, yields, sample);
  double further_root = 0.0;
  for (std::size_t touch = 0; touch < forces.size(); ++touch) {
    add_force(states_, contacts.point(touch), forces[touch]);
    further_root += yields[touch] * forces[touch];
  }
  if (stretching_) {
    stretching_->end(states_, stretching_->free_root() + std::sqrt(stretching_->rise()) * further_root);
  }
}

template <std::size_t outputs>
void ResonatorBank::touch_all(std::span<const Drive> drives, PointContacts& contacts, std::span<const ModeGroup> gains,
                              std::span<double> sound) {
  hear_all();
  catch_up();
  std::ranges::fill(moving_, 1);
  if (stretching_) {
    stretching_->wake();
  }
  std::array<double, PointContacts::most> free{};
  const std::size_t samples = sound.size() / outputs;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    std::ranges::copy_n(states_.begin(), std::ssize(before_), before_.begin());
    SampleSums<outputs> sums;
    for (std::size_t group = 0; group < groups(); ++group) {
      const ModeGroup before = states_[group];
      const GroupGains<outputs> of_group = gains_of<outputs>(group, groups(), gains);
      for (std::size_t o = 0; o < outputs; ++o) {
        sums.heard[o] = with_sound(sums.heard[o], *of_group[o], before);
      }
      advance_free(states_[group], turns_[group], drives, group, sample);
      const ModeGroup moved = change(states_[group], before);
      for (std::size_t touch = 0; touch < contacts.count(); ++touch) {
        sums.ways[touch] = with_sound(sums.ways[touch], contacts.point(touch).displacement[group], moved);
      }
    }
    std::ranges::transform(sums.heard, sound.begin() + static_cast<std::ptrdiff_t>(sample * outputs),
                           sum_of_lanes<ModePack>);
    std::ranges::transform(sums.ways, free.begin(), sum_of_lanes<ModePack>);
    add_forces(contacts, free, sample);
  }
  for (const Drive& one : drives) {
    take_following_sound<outputs>(one, turns_, gains, sound);
  }
  for (std::size_t touch = 0; touch < contacts.count(); ++touch) {
    const ContactPoint& point = contacts.point(touch);
    take_following_sound<outputs>(
        {.force = contacts.pieces(touch, samples), .by_mean = point.by_mean, .by_slope = point.by_slope}, turns_, gains,
        sound);
  }
}

}  // namespace idiophone::resonators
