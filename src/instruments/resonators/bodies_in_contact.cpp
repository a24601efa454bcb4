#include "idiophone/instruments/resonators/bodies_in_contact.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "following_sound.hpp"
#include "mode_groups.hpp"

namespace idiophone::resonators {

namespace {

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

/// Takes away what the modes do when they only follow the forces.
template <std::size_t outputs>
void take_following_sounds(const BodyInContact& body, std::span<const ContactSide> sides) {
  const std::span<const ModeGroup> turns = body.bank->turns();
  for (const Drive& one : body.drives) {
    take_following_sound<outputs>(one, turns, body.gains, body.sound);
  }
  for (const ContactSide& side : sides) {
    take_following_sound<outputs>({.force = std::span(side.pieces).first(body.sound.size() / outputs),
                                   .by_mean = side.point->by_mean,
                                   .by_slope = side.point->by_slope},
                                  turns, body.gains, body.sound);
  }
}

/// Calls a function with the number of outputs as a constant.
template <class Function>
void with_outputs(std::size_t outputs, const Function& function) {
  switch (outputs) {
    case 1:
      return function.template operator()<1>();
    case 2:
      return function.template operator()<2>();
    case 4:
      return function.template operator()<4>();
    case 8:
      return function.template operator()<8>();
    default:
      assert(!"1, 2, 4 or 8 outputs");
  }
}

}  // namespace

bool ResonatorBank::stretches(std::span<const Drive> drives) const {
  return stretching_ && (stretching_->acts() || std::ranges::any_of(drives, &Drive::acts));
}

std::size_t ResonatorBank::stretching_operations() const {
  return stretching_ ? stretching_->operations() : 0;
}

void ResonatorBank::begin_samples() {
  hear_all();
  catch_up();
  std::ranges::fill(moving_, 1);
  if (stretching_) {
    stretching_->wake();
  }
}

/// Without contacts and stretching; the sides get their free ways.
template <std::size_t outputs>
void ResonatorBank::advance_freely(const BodyInContact& body, std::span<ContactSide> sides, std::size_t sample) {
  std::array<ModePack, outputs> heard{};
  std::array<ModePack, PointContacts::most + PointContacts::most_staying> ways{};
  if (stretching_) {
    std::ranges::copy(states_, before_.begin());
  }
  for (std::size_t group = 0; group < groups(); ++group) {
    const ModeGroup before = states_[group];
    const GroupGains<outputs> of_group = gains_of<outputs>(group, groups(), body.gains);
    for (std::size_t o = 0; o < outputs; ++o) {
      heard[o] = with_sound(heard[o], *of_group[o], before);
    }
    advance_free(states_[group], turns_[group], body.drives, group, sample);
    const ModeGroup moved = change(states_[group], before);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      ways[side] = with_sound(ways[side], sides[side].point->displacement[group], moved);
    }
  }
  std::ranges::transform(heard, body.sound.begin() + static_cast<std::ptrdiff_t>(sample * outputs),
                         sum_of_lanes<ModePack>);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    sides[side].free = sum_of_lanes(ways[side]);
  }
}

/// Finds the force of stretching, and what it does to the points of contact.
void ResonatorBank::stretch(std::span<ContactSide> sides) {
  if (!stretching_) {
    return;
  }
  stretching_->find_force(before_, states_);
  for (ContactSide& side : sides) {
    ModePack pulled{};
    for (std::size_t group = 0; group < groups(); ++group) {
      pulled = with_sound(pulled, side.point->displacement[group], stretching_->pull()[group]);
    }
    const double way = sum_of_lanes(pulled);
    side.free -= stretching_->free_root() * way;
    side.yield = std::sqrt(stretching_->rise()) * way;
  }
}

/// Those of stretching and of contacts.
void ResonatorBank::add_forces(std::span<const ContactSide> sides, const PointContacts& contacts) {
  double further_root = 0.0;
  for (const ContactSide& side : sides) {
    const double force = contacts.force(side);
    add_force(states_, *side.point, force);
    further_root += side.yield * force;
  }
  if (stretching_) {
    stretching_->end(states_, stretching_->free_root() + std::sqrt(stretching_->rise()) * further_root);
  }
}

/// Leaves out of the sound what the modes do in a sample while they only follow the force of stretching.
template <std::size_t outputs>
void ResonatorBank::leave_out_following(const BodyInContact& body, std::size_t sample) const {
  if (!stretching_) {
    return;
  }
  std::array<ModePack, outputs> heard{};
  for (std::size_t group = 0; group < groups(); ++group) {
    const GroupGains<outputs> of_group = gains_of<outputs>(group, groups(), body.gains);
    for (std::size_t o = 0; o < outputs; ++o) {
      heard[o] = with_sound(heard[o], *of_group[o], stretching_->following()[group]);
    }
  }
  for (std::size_t o = 0; o < outputs; ++o) {
    body.sound[sample * outputs + o] -= sum_of_lanes(heard[o]);
  }
}

void ResonatorBank::advance(std::span<const Drive> drives, PointContacts& contacts, std::span<const ModeGroup> gains,
                            std::size_t outputs, std::span<double> sound) {
  const BodyInContact body{.bank = this, .drives = drives, .gains = gains, .outputs = outputs, .sound = sound};
  advance_together({&body, 1}, contacts);
}

void advance_together(std::span<const BodyInContact> bodies, PointContacts& contacts) {
  for (const BodyInContact& body : bodies) {
    body.bank->begin_samples();
  }
  const std::size_t samples = bodies.front().sound.size() / bodies.front().outputs;
  for (std::size_t sample = 0; sample < samples; ++sample) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      with_outputs(bodies[i].outputs, [&]<std::size_t outputs>() {
        bodies[i].bank->advance_freely<outputs>(bodies[i], contacts.sides(i), sample);
      });
      bodies[i].bank->stretch(contacts.sides(i));
    }
    contacts.advance(sample);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bodies[i].bank->add_forces(contacts.sides(i), contacts);
      with_outputs(bodies[i].outputs,
                   [&]<std::size_t outputs>() { bodies[i].bank->leave_out_following<outputs>(bodies[i], sample); });
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    with_outputs(bodies[i].outputs,
                 [&]<std::size_t outputs>() { take_following_sounds<outputs>(bodies[i], contacts.sides(i)); });
  }
}

}  // namespace idiophone::resonators
