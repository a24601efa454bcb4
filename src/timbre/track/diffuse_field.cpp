#include "diffuse_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::timbre {

namespace {

constexpr std::size_t wave_count = 32;  // enough for 0.2 m: at 20 kHz, their delays differ by half a period

bool is_prime(std::size_t number) {
  for (std::size_t divisor = 2; divisor * divisor <= number; ++divisor) {
    if (number % divisor == 0) {
      return false;
    }
  }
  return number > 1;
}

/// Prime numbers of samples, whose logarithms are evenly spaced from 30 to 63 ms.
std::vector<std::size_t> prime_lengths(int rate) {
  constexpr double shortest = 0.030, longest = 0.063;  // s
  std::vector<std::size_t> lengths;
  for (std::size_t w = 0; w < wave_count; ++w) {
    const double share = static_cast<double>(w) / (wave_count - 1);
    auto length = static_cast<std::size_t>(rate * shortest * std::pow(longest / shortest, share));
    while (!is_prime(length) || std::ranges::find(lengths, length) != lengths.end()) {
      ++length;
    }
    lengths.push_back(length);
  }
  return lengths;
}

/// What all lines have in common, because they have one input, cancels.
double sign_of(std::size_t wave) {
  return wave % 2 == 0 ? 1.0 : -1.0;
}

/// Unit vectors spread evenly over the sphere: a spiral whose points turn by the golden angle.
Vector3 direction_of(std::size_t wave) {
  const double height = 1.0 - (2.0 * static_cast<double>(wave) + 1.0) / wave_count;
  const double angle = static_cast<double>(wave) * std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt(1.0 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

}  // namespace

DiffuseField::DiffuseField(const std::vector<scene::Receiver>& receivers, double decay, double speed, int rate)
    : lines_(prime_lengths(rate), decay, rate), delays_(receivers.size()), gains_(receivers.size()) {
  std::size_t longest = 0;
  for (std::size_t w = 0; w < wave_count; ++w) {
    const Vector3 direction = direction_of(w);  // in which the wave travels
    const auto along = [&](const scene::Receiver& receiver) { return direction.dot(receiver.position); };
    const double first = along(*std::ranges::min_element(receivers, {}, along));
    for (std::size_t r = 0; r < receivers.size(); ++r) {
      const auto delay = static_cast<std::size_t>(std::lround((along(receivers[r]) - first) / speed * rate));
      const double share = receivers[r].directivity;
      delays_[r].push_back(delay);
      gains_[r].push_back(sign_of(w) * (1.0 - share - share * direction.dot(receivers[r].axis)) /
                          std::sqrt(double{wave_count}));
      longest = std::max(longest, delay);
    }
  }
  past_.assign(longest + 1, std::vector<double>(wave_count));
}

void DiffuseField::step(double input, std::span<double> sounds) {
  now_ = now_ + 1 == past_.size() ? 0 : now_ + 1;
  std::ranges::copy(lines_.step(input), past_[now_].begin());
  for (std::size_t r = 0; r < sounds.size(); ++r) {
    sounds[r] = 0.0;
    for (std::size_t w = 0; w < wave_count; ++w) {
      const std::size_t delay = delays_[r][w];
      sounds[r] += gains_[r][w] * past_[now_ >= delay ? now_ - delay : now_ + past_.size() - delay][w];
    }
  }
}

}  // namespace idiophone::timbre
