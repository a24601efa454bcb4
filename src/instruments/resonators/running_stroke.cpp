#include "idiophone/instruments/resonators/running_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "contact_spring.hpp"
#include "idiophone/foundation/random_numbers.hpp"

namespace idiophone::resonators {

namespace {

constexpr std::size_t wave_count =
    32 * lane_count;  // evenly spaced in the logarithm of their lengths, some 16 an octave
constexpr double full_turn = 2.0 * std::numbers::pi;

/// A complex number in each lane.
struct ComplexLanes {
  Lanes4 real{}, imaginary{};

  void set(std::size_t lane, const Complex& value) {
    real[lane] = value.real();
    imaginary[lane] = value.imag();
  }
  ComplexLanes operator*(const ComplexLanes& other) const {
    return {real * other.real - imaginary * other.imaginary, real * other.imaginary + imaginary * other.real};
  }
};

}  // namespace

RunningStroke::RunningStroke(const score::Stroke& stroke, std::uint64_t seed, int rate)
    : stroke_(stroke), rate_(rate), now_{stroke.speed, 0.0}, wanted_{stroke.speed, stroke.load} {
  const score::Roughness& rough = stroke.roughness;
  std::mt19937_64 random(seed);
  double power = 0.0;
  for (std::size_t i = 0; i < wave_count; ++i) {
    const double place = (static_cast<double>(i) + uniform(random)) / wave_count;
    const double length = rough.longest * std::pow(rough.shortest / rough.longest, place);
    // A power of 1/frequency^exponent in each hertz is one of frequency^(1 - exponent) in each octave.
    const double height = std::pow(rough.longest / length, 0.5 * (1.0 - rough.exponent));
    power += 0.5 * height * height;
    waves_.push_back({full_turn / length, height, full_turn * uniform(random)});
  }
  for (Wave& wave : waves_) {
    wave.height *= rough.height / std::sqrt(power);
  }
  forces_ = forces_at(now_);
}

void RunningStroke::change(double speed, double load) {
  wanted_ = {speed, ends_ ? 0.0 : load};
}

void RunningStroke::end() {
  ends_ = true;
  wanted_.load = 0.0;
}

std::vector<Complex> RunningStroke::forces_at(const Motion& motion) const {
  std::vector<Complex> forces(waves_.size());
  if (motion.load <= 0.0) {
    return forces;
  }
  const ContactSpring spring(stroke_, motion.load);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const double angular = waves_[i].number * motion.speed;
    if (angular < std::numbers::pi * rate_) {
      forces[i] = waves_[i].height * spring.force(angular, waves_[i].number);
    }
  }
  return forces;
}

/// A lane is a wave.
void RunningStroke::add_waves(std::size_t number, const Motion& next, std::span<const Complex> forces,
                              std::vector<double>& sum) {
  constexpr double share = 1.0 / block;
  ComplexLanes first, change, state, step, faster;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    Wave& wave = waves_[number + lane];
    const double first_step = wave.number * now_.speed / rate_, last_step = wave.number * next.speed / rate_;
    const double growth = share * (last_step - first_step);
    first.set(lane, forces_[number + lane]);
    change.set(lane, share * (forces[number + lane] - forces_[number + lane]));
    state.set(lane, std::polar(1.0, wave.phase));
    step.set(lane, std::polar(1.0, first_step + 0.5 * growth));
    faster.set(lane, std::polar(1.0, growth));
    wave.phase = std::fmod(wave.phase + 0.5 * block * (first_step + last_step), full_turn);
  }
  for (std::size_t n = 0; n <= block; ++n) {
    const auto passed = static_cast<double>(n);
    const ComplexLanes amplitude{first.real + passed * change.real, first.imaginary + passed * change.imaginary};
    const Lanes4 force = amplitude.real * state.real - amplitude.imaginary * state.imaginary;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      sum[n] += force[lane];
    }
    state = state * step;
    step = step * faster;
  }
}

PointForce RunningStroke::at_place() const {
  const Vector3 whole = stroke_.to - stroke_.from;
  const bool returns = way_ > whole.norm();
  const Vector3 along = whole.normalized();
  return {.at = stroke_.from + (returns ? 2.0 * whole.norm() - way_ : way_) * along,
          .direction = stroke_.direction + (returns ? -stroke_.friction : stroke_.friction) * along};
}

std::vector<PointForce> RunningStroke::next(std::int64_t start) {
  const Motion then = wanted_;
  std::vector<double> force(block + 1);
  std::vector<Complex> forces = forces_at(then);
  for (std::size_t number = 0; number < waves_.size(); number += lane_count) {
    add_waves(number, then, forces, force);
  }
  forces_ = std::move(forces);
  PointForce first = at_place();
  way_ = std::fmod(way_ + 0.5 * (now_.speed + then.speed) * block / rate_, 2.0 * (stroke_.to - stroke_.from).norm());
  PointForce last = at_place();
  for (std::size_t n = 0; n <= block; ++n) {
    const double load = now_.load + (then.load - now_.load) * static_cast<double>(n) / block;
    force[n] = std::max(0.0, load + force[n]);
  }
  for (std::size_t n = 0; n < block; ++n) {
    const double share = static_cast<double>(n) / block, later = static_cast<double>(n + 1) / block;
    first.force.push_back(linear_piece((1.0 - share) * force[n], (1.0 - later) * force[n + 1]));
    last.force.push_back(linear_piece(share * force[n], later * force[n + 1]));
  }
  now_ = then;
  first.start = last.start = start;
  return {first, last};
}

}  // namespace idiophone::resonators
