#include "modal_amplitudes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::measured_maps {

namespace {

using Complex = std::complex<double>;

/// The direction in the complex plane along which numbers lie, on both sides of zero: a number of magnitude 1.
Complex direction_of(const std::vector<Complex>& numbers) {
  Complex squares = 0.0;
  for (const Complex number : numbers) {
    squares += number * number;
  }
  return std::abs(squares) > 0.0 ? std::sqrt(squares / std::abs(squares)) : 1.0;
}

std::vector<Complex> of_microphone(const Heard& heard, std::size_t microphone) {
  std::vector<Complex> numbers;
  for (const auto& of_blow : heard) {
    numbers.push_back(of_blow[microphone]);
  }
  return numbers;
}

/// [modes][microphones]
using Directions = std::vector<std::vector<Complex>>;

double power_of(const std::vector<Heard>& heard, std::size_t blow) {
  double power = 0.0;
  for (const Heard& mode : heard) {
    for (const Complex number : mode[blow]) {
      power += std::norm(number);
    }
  }
  return power;
}

/// How far the pressures of a blow lie along the directions when its sound comes later by a time, s.
double agreement(const std::vector<Heard>& heard, std::span<const double> frequency, const Directions& directions,
                 std::size_t blow, double time) {
  double sum = 0.0;
  for (std::size_t mode = 0; mode < heard.size(); ++mode) {
    const Complex turn = std::polar(1.0, 2.0 * std::numbers::pi * frequency[mode] * time);
    for (std::size_t m = 0; m < directions[mode].size(); ++m) {
      const Complex number = heard[mode][blow][m];
      const double along = (number * turn * std::conj(directions[mode][m])).real();
      sum += along * along / std::max(std::abs(number), 1e-300);
    }
  }
  return sum;
}

/// The time of best agreement. Of times that agree almost alike, the shorter one wins.
double best_time(const std::vector<Heard>& heard, std::span<const double> frequency, const Directions& directions,
                 std::size_t blow) {
  constexpr double longest = 1.5e-3;  // s
  const double step = 1.0 / (20.0 * std::ranges::max(frequency));
  const auto steps = static_cast<int>(longest / step);
  double best = -1.0, time = 0.0;
  for (int i = -steps; i <= steps; ++i) {
    const double share = i * step / longest;
    const double value = (1.0 - 0.1 * share * share) * agreement(heard, frequency, directions, blow, i * step);
    if (value > best) {
      best = value;
      time = i * step;
    }
  }
  return time;
}

void delay(std::vector<Heard>& heard, std::span<const double> frequency, std::size_t blow, double time) {
  for (std::size_t mode = 0; mode < heard.size(); ++mode) {
    for (Complex& number : heard[mode][blow]) {
      number *= std::polar(1.0, 2.0 * std::numbers::pi * frequency[mode] * time);
    }
  }
}

}  // namespace

void align(std::vector<Heard>& heard, std::span<const double> frequency, const std::vector<bool>& fixed) {
  constexpr int rounds = 4;
  std::size_t strongest = 0;
  for (std::size_t blow = 0; blow < fixed.size(); ++blow) {
    strongest = power_of(heard, blow) > power_of(heard, strongest) ? blow : strongest;
  }
  Directions directions;
  for (const Heard& mode : heard) {
    auto& of_mode = directions.emplace_back();
    for (const Complex number : mode[strongest]) {
      of_mode.push_back(direction_of({number}));
    }
  }
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t blow = 0; blow < fixed.size(); ++blow) {
      if (!fixed[blow] && blow != strongest) {
        delay(heard, frequency, blow, best_time(heard, frequency, directions, blow));
      }
    }
    for (std::size_t mode = 0; mode < heard.size(); ++mode) {
      for (std::size_t m = 0; m < directions[mode].size(); ++m) {
        directions[mode][m] = direction_of(of_microphone(heard[mode], m));
      }
    }
  }
}

SeparatedMode separate(const Heard& heard) {
  constexpr int rounds = 30;
  const std::size_t blows = heard.size(), microphones = heard.front().size();
  std::size_t loudest = 0;
  const auto power = [&](std::size_t microphone) {
    double sum = 0.0;
    for (const Complex number : of_microphone(heard, microphone)) {
      sum += std::norm(number);
    }
    return sum;
  };
  for (std::size_t m = 1; m < microphones; ++m) {
    loudest = power(m) > power(loudest) ? m : loudest;
  }
  SeparatedMode mode{.strength = {}, .pressure = std::vector<Complex>(microphones)};
  const Complex direction = direction_of(of_microphone(heard, loudest));
  for (const Complex number : of_microphone(heard, loudest)) {
    mode.strength.push_back((number * std::conj(direction)).real());
  }
  for (int round = 0; round < rounds; ++round) {
    double square = 0.0;
    for (const double strength : mode.strength) {
      square += strength * strength / static_cast<double>(blows);
    }
    const double scale = 1.0 / std::sqrt(std::max(square, 1e-300));
    double heard_power = 0.0;
    for (std::size_t m = 0; m < microphones; ++m) {
      mode.pressure[m] = 0.0;
      for (std::size_t blow = 0; blow < blows; ++blow) {
        mode.pressure[m] += scale * mode.strength[blow] * heard[blow][m] / static_cast<double>(blows);
      }
      heard_power += std::norm(mode.pressure[m]);
    }
    for (std::size_t blow = 0; blow < blows; ++blow) {
      mode.strength[blow] = 0.0;
      for (std::size_t m = 0; m < microphones; ++m) {
        mode.strength[blow] += (std::conj(mode.pressure[m]) * heard[blow][m]).real() / std::max(heard_power, 1e-300);
      }
    }
  }
  return mode;
}

}  // namespace idiophone::measured_maps
