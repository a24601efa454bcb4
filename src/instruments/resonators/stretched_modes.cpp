#include "idiophone/instruments/resonators/stretched_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mode_groups.hpp"

namespace idiophone::resonators {

namespace {

constexpr double offset_in_energies = 2.0;  // of modes and stretching together, or of stretching below zero
constexpr double correction = 0.01;         // share of a drift that an audio sample takes back
constexpr double inaudible_share = 1e-5;    // -100 dB
constexpr double smallest_place = 1e-16;    // kg^1/2 m; squares of smaller ones would be denormal
constexpr double smallest_energy = 1e-40;   // J

template <class Numbers>
double product(const Numbers& a, const Numbers& b) {
  ModePack sum{};
  for (std::size_t group = 0; group < a.size(); ++group) {
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      sum += a[group][p] * b[group][p];
    }
  }
  return sum_of_lanes(sum);
}

}  // namespace

StretchedModes::StretchedModes(StretchingEnergy energy, std::span<const double> rotation,
                               std::span<const ModeGroup> turns, int rate)
    : energy_(std::move(energy)),
      rotation_(rotation.begin(), rotation.end()),
      rate_(rate),
      factors_(turns.size()),
      places_(turns.size() * modes_in_group),
      slopes_(places_.size()),
      ways_(turns.size()),
      gradient_(turns.size()),
      pull_(turns.size()),
      forces_(turns.size()),
      following_(turns.size()) {
  retune(turns, 1.0);
}

/// A body that is s times as long has A 1/s and H s^(-7/2) times as large: V at q is that of the original at
/// s^(-7/4) q with A s^(3/4) times as large.
void StretchedModes::retune(std::span<const ModeGroup> turns, double size) {
  places_scale_ = static_cast<float>(std::pow(size, -1.75));
  bend_ = static_cast<float>(std::pow(size, 0.75));
  for (std::size_t mode = 0; mode < places_.size(); ++mode) {
    Factors& factors = factors_[mode / modes_in_group];
    const std::size_t p = mode % modes_in_group / modes_in_pack, lane = mode % modes_in_pack;
    const Complex turn = value_of(turns[mode / modes_in_group], mode);
    const bool sounds = turn != 0.0;
    const Complex exponent = sounds ? rate_ * std::log(turn) : Complex(0.0, 1.0);
    const Complex half_turn = sounds ? std::sqrt(turn) : 0.0;
    const Complex by_mean = sounds ? (turn - 1.0) / exponent : 0.0;
    const Complex by_following = sounds ? -1.0 / exponent : 0.0;
    factors.half_turn.real[p][lane] = half_turn.real();
    factors.half_turn.imaginary[p][lane] = half_turn.imag();
    factors.by_mean.real[p][lane] = by_mean.real();
    factors.by_mean.imaginary[p][lane] = by_mean.imag();
    factors.by_following.real[p][lane] = by_following.real();
    factors.by_following.imaginary[p][lane] = by_following.imag();
    const Complex by_change = by_following / exponent * static_cast<double>(rate_);
    factors.by_change.real[p][lane] = by_change.real();
    factors.by_change.imaginary[p][lane] = by_change.imag();
    factors.period[p][lane] = sounds ? 1.0 / exponent.imag() : 0.0;
    factors.slip[p][lane] = -exponent.real() / exponent.imag();
    factors.stiffness[p][lane] = std::norm(exponent);
  }
}

void StretchedModes::rest_if_small() {
  if (largest_share_ < inaudible_share) {
    acts_ = false;
    stored_ = 0.0;
    std::ranges::fill(forces_, GroupNumbers{});
  }
  largest_share_ = 0.0;
}

/// Without that of stretching, J.
double StretchedModes::energy_of(std::span<const ModeGroup> states) const {
  ModePack sum{};
  for (std::size_t group = 0; group < states.size(); ++group) {
    const ModeGroup& z = states[group];
    const Factors& factors = factors_[group];
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      const ModePack velocity = z.real[p] - factors.slip[p] * z.imaginary[p];
      const ModePack place = factors.period[p] * z.imaginary[p];
      sum += velocity * velocity + factors.stiffness[p] * place * place;
    }
  }
  return sum_of_lanes(sum) / 2;
}

/// Where the modes are in half a sample without the force.
void StretchedModes::find_middle(std::span<const ModeGroup> before) {
  for (std::size_t group = 0; group < before.size(); ++group) {
    ModeGroup z;
    multiply(z, before[group], factors_[group].half_turn);
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      const ModePack place = factors_[group].period[p] * z.imaginary[p];
      float* places = &places_[group * modes_in_group + p * modes_in_pack];
      for (std::size_t lane = 0; lane < modes_in_pack; ++lane) {
        places[lane] = std::abs(place[lane]) < smallest_place ? 0.0F : places_scale_ * static_cast<float>(place[lane]);
      }
    }
  }
}

/// Now and then: it takes as many multiply-adds as there are pairs of modes. Of a body that is s times as long, T is
/// s^-5 times as large.
void StretchedModes::watch_rotation() {
  constexpr int interval = 16;  // audio samples
  if (until_watched_-- > 0) {
    return;
  }
  until_watched_ = interval - 1;
  const std::size_t modes = energy_.modes();
  double square = 0.0;
  for (std::size_t mode = 0; mode < modes; ++mode) {
    const auto row = std::span(rotation_).subspan(mode * modes, modes);
    square += static_cast<double>(places_[mode] * std::inner_product(row.begin(), row.end(), places_.begin(), 0.0F));
  }
  const double angle = std::sqrt(std::max(square, 0.0)) / static_cast<double>(bend_);
  largest_rotation_.set(std::max(largest_rotation_.now(), angle));
}

void StretchedModes::find_gradient(double energy_of_modes) {
  const std::size_t modes = energy_.modes();
  const double energy = energy_.at(std::span(places_).first(modes), bend_, std::span(slopes_).first(modes));
  // The sum is nearly zero where a shell snapped through: it has as much less stored than at rest as its modes have.
  offset_ = std::max({offset_in_energies * (energy_of_modes + stored_), -offset_in_energies * energy, -stored_});
  root_ = std::sqrt(2 * (stored_ + offset_));
  level_ = std::sqrt(2 * std::max(energy + offset_, smallest_energy));
  largest_share_ = std::max(largest_share_, std::abs(energy) / std::max(energy_of_modes, smallest_energy));
  const double scale = places_scale_ / level_;
  for (std::size_t mode = 0; mode < modes; ++mode) {
    gradient_[mode / modes_in_group][mode % modes_in_group / modes_in_pack][mode % modes_in_pack] =
        scale * static_cast<double>(slopes_[mode]);
  }
}

/// A part of g along the way of the modes lets p approach sqrt(2 (V + offset)). What p gets the modes lose.
void StretchedModes::correct_drift(double energy_of_modes) {
  const double drift = level_ - (root_ + product(gradient_, ways_) / 2);
  const double scale = correction * drift * rate_ * rate_ / (2 * std::max(energy_of_modes, smallest_energy));
  for (std::size_t group = 0; group < gradient_.size(); ++group) {
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      gradient_[group][p] += scale * ways_[group][p];
    }
  }
}

/// What g, as a force on the modes, does to them in a sample.
void StretchedModes::find_response() {
  ModePack sum{};
  for (std::size_t group = 0; group < gradient_.size(); ++group) {
    const ModeGroup& by_mean = factors_[group].by_mean;
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      pull_[group].real[p] = by_mean.real[p] * gradient_[group][p];
      pull_[group].imaginary[p] = by_mean.imaginary[p] * gradient_[group][p];
      sum += gradient_[group][p] * factors_[group].period[p] * pull_[group].imaginary[p];
    }
  }
  response_ = sum_of_lanes(sum);
}

void StretchedModes::find_force(std::span<const ModeGroup> before, std::span<const ModeGroup> free) {
  for (std::size_t group = 0; group < before.size(); ++group) {
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      ways_[group][p] = factors_[group].period[p] * (free[group].imaginary[p] - before[group].imaginary[p]);
    }
  }
  const double energy_of_modes = energy_of(before);
  find_middle(before);
  watch_rotation();
  find_gradient(energy_of_modes);
  correct_drift(std::max(energy_of_modes, energy_of(free)));  // a force may just begin
  find_response();
  free_root_ = (root_ + product(gradient_, ways_) / 2) / (1 + response_ / 2);
}

/// The force is constant in a sample. At the beginning it is the mean of this and the last one, and changes by their
/// difference in a sample.
void StretchedModes::follow(double mean_root) {
  for (std::size_t group = 0; group < forces_.size(); ++group) {
    const Factors& factors = factors_[group];
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      const ModePack force = -mean_root * gradient_[group][p];
      const ModePack at_beginning = (forces_[group][p] + force) / 2;
      const ModePack change = force - forces_[group][p];
      following_[group].real[p] = factors.by_following.real[p] * at_beginning + factors.by_change.real[p] * change;
      following_[group].imaginary[p] =
          factors.by_following.imaginary[p] * at_beginning + factors.by_change.imaginary[p] * change;
      forces_[group][p] = force;
    }
  }
}

void StretchedModes::end(std::span<ModeGroup> after, double mean_root) {
  follow(mean_root);
  for (std::size_t group = 0; group < after.size(); ++group) {
    for (std::size_t p = 0; p < packs_in_group; ++p) {
      after[group].real[p] -= mean_root * pull_[group].real[p];
      after[group].imaginary[p] -= mean_root * pull_[group].imaginary[p];
    }
  }
  const double root = 2 * mean_root - root_;
  stored_ = root * root / 2 - offset_;
}

}  // namespace idiophone::resonators
