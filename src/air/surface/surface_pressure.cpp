#include "idiophone/air/surface/surface_pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::surface {

namespace {

using Complex = std::complex<double>;

/// Integral of exp(x t) (1 - t) over t from 0 to 1: (exp(x) - 1 - x)/x^2.
Complex falling_ramp(Complex x) {
  if (std::abs(x) > 1.0) {
    return (std::exp(x) - 1.0 - x) / (x * x);
  }
  Complex sum = 0.0, term = 0.5;
  for (int power = 0; power < 20; ++power) {
    sum += term;
    term *= x / (power + 3.0);
  }
  return sum;
}

}  // namespace

SurfacePressure::SurfacePressure(Field field, const std::vector<double>& radii, double metres_per_sample)
    : metres_per_sample_(metres_per_sample),
      radii_(radii.size(), std::numeric_limits<double>::quiet_NaN()),  // differs from every radius
      root_(-1.0, field == Field::pulsating ? 0.0 : 1.0),
      gain_(1.0, field == Field::pulsating ? 0.0 : -1.0) {
  for (auto* parts : {&decay_, &before_, &now_, &memory_}) {
    parts->fill(std::vector<double>(padded(radii.size())));
  }
  set_radii(radii);
}

void SurfacePressure::set_radii(std::span<const double> radii) {
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (radii[i] != radii_[i]) {
      set_radius(i, radii[i]);
    }
  }
}

void SurfacePressure::set_radius(std::size_t triangle, double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw std::invalid_argument(fmt::format(
        "surface pressure: the radius of triangle {} is {} m; it has to be above 0 and finite", triangle, radius));
  }
  radii_[triangle] = radius;
  const double pace = metres_per_sample_ / radius;  // (c/a) in an audio sample
  const Complex exponent = pace * root_;
  const Complex falling = falling_ramp(exponent);
  const Complex whole = 1.0 + exponent * falling;  // integral of exp(x t) alone
  const auto set = [&](ComplexValues& parts, Complex value) {
    parts[0][triangle] = value.real();
    parts[1][triangle] = value.imag();
  };
  set(decay_, std::exp(exponent));
  set(now_, pace * falling);
  set(before_, pace * (whole - falling));
}

void SurfacePressure::start(std::span<const double> plane_wave) {
  const Complex steady = -1.0 / root_;  // q' = 0
  for (std::size_t i = 0; i < memory_[0].size(); ++i) {
    memory_[0][i] = steady.real() * plane_wave[i];
    memory_[1][i] = steady.imag() * plane_wave[i];
  }
}

void SurfacePressure::step(std::span<const double> before, std::span<const double> now, std::span<double> pressure) {
  std::ranges::copy(now, pressure.begin());
  for (std::size_t i = 0; i < memory_[0].size(); i += wide_count) {
    const auto part = [i](const ComplexValues& parts, std::size_t which) { return load<WideLanes>(&parts[which][i]); };
    const WideLanes then = load<WideLanes>(&before[i]);
    const WideLanes plane_wave = load<WideLanes>(&now[i]);
    const WideLanes real = part(decay_, 0) * part(memory_, 0) - part(decay_, 1) * part(memory_, 1) +
                           part(before_, 0) * then + part(now_, 0) * plane_wave;
    const WideLanes imaginary = part(decay_, 0) * part(memory_, 1) + part(decay_, 1) * part(memory_, 0) +
                                part(before_, 1) * then + part(now_, 1) * plane_wave;
    put(real, &memory_[0][i]);
    put(imaginary, &memory_[1][i]);
    put(plane_wave - (gain_.real() * real - gain_.imag() * imaginary), &pressure[i]);
  }
}

void SurfacePressure::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  if (root_ == 0.0) {
    return;
  }
  for (auto& part : memory_) {
    row.value(part[triangle]);
  }
}

}  // namespace idiophone::surface
