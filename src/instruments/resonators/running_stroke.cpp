#include "idiophone/instruments/resonators/running_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "contact_spring.hpp"

namespace idiophone::resonators {

namespace {

constexpr std::size_t wave_count = 128;  // evenly spaced in the logarithm of their lengths, some 16 an octave
constexpr double full_turn = 2.0 * std::numbers::pi;

/// Force of a wave, N; none for waves that pass faster than the rate can hold.
Complex force_of_wave(const score::Stroke& stroke, double speed, double load, double wave_number, int rate) {
  const double angular = wave_number * speed;
  if (load <= 0.0 || angular >= std::numbers::pi * rate) {
    return 0.0;
  }
  return ContactSpring(stroke, load).force(angular, wave_number);
}

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
}

void RunningStroke::change(double speed, double load) {
  wanted_ = {speed, ends_ ? 0.0 : load};
}

void RunningStroke::end() {
  ends_ = true;
  wanted_.load = 0.0;
}

void RunningStroke::add_wave(Wave& wave, const Motion& next, std::vector<double>& force) const {
  constexpr double share = 1.0 / block;
  const auto gain = [&](const Motion& at) {
    return wave.height * force_of_wave(stroke_, at.speed, at.load, wave.number, rate_);
  };
  const Complex first = gain(now_), change = share * (gain(next) - first);
  const double first_step = wave.number * now_.speed / rate_, last_step = wave.number * next.speed / rate_;
  const double growth = share * (last_step - first_step);
  Complex state = std::polar(1.0, wave.phase), step = std::polar(1.0, first_step + 0.5 * growth);
  const Complex faster = std::polar(1.0, growth);
  for (std::size_t n = 0; n <= block; ++n) {
    force[n] += ((first + static_cast<double>(n) * change) * state).real();
    state *= step;
    step *= faster;
  }
  wave.phase = std::fmod(wave.phase + 0.5 * block * (first_step + last_step), full_turn);
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
  for (Wave& wave : waves_) {
    add_wave(wave, then, force);
  }
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
