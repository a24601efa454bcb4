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

/// Sum over n of x^n/(n + order)!. Of order k + 1, times k!, it is the integral of exp(x (1 - t)) t^k over t from 0
/// to 1.
Complex phi(int order, Complex x) {
  if (std::abs(x) > 1.0) {
    return order == 0 ? std::exp(x) : (phi(order - 1, x) - 1.0 / std::tgamma(order)) / x;
  }
  Complex sum = 0.0, term = 1.0 / std::tgamma(order + 1);
  for (int power = 1; power <= 20; ++power) {
    sum += term;
    term *= x / static_cast<double>(order + power);
  }
  return sum;
}

}  // namespace

SurfacePressure::SurfacePressure(Field field, const std::vector<double>& radii, double metres_per_sample)
    : metres_per_sample_(metres_per_sample),
      radii_(radii.size(), std::numeric_limits<double>::quiet_NaN()),  // differs from every radius
      root_(-1.0, field == Field::pulsating ? 0.0 : 1.0),
      gain_(1.0, field == Field::pulsating ? 0.0 : -1.0) {
  for (auto* parts : {&decay_, &now_, &before_, &earlier_, &memory_}) {
    parts->fill(std::vector<double>(padded(radii.size())));
  }
  past_.resize(padded(radii.size()));
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
  const Complex constant = phi(1, exponent);  // what P = 1, t and t^2 add, t from the last audio sample
  const Complex line = phi(2, exponent);
  const Complex parabola = 2.0 * phi(3, exponent);
  const auto set = [&](ComplexValues& parts, Complex value) {
    parts[0][triangle] = value.real();
    parts[1][triangle] = value.imag();
  };
  set(decay_, std::exp(exponent));
  set(now_, pace * (parabola + line) / 2.0);
  set(before_, pace * (constant - parabola));
  set(earlier_, pace * (parabola - line) / 2.0);
}

void SurfacePressure::start(std::span<const double> plane_wave) {
  std::ranges::copy(plane_wave.first(past_.size()), past_.begin());
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
    const auto earlier = load<WideLanes>(&past_[i]);
    const auto last = load<WideLanes>(&before[i]);
    const auto plane_wave = load<WideLanes>(&now[i]);
    const auto added = [&](std::size_t which) {
      return part(earlier_, which) * earlier + part(before_, which) * last + part(now_, which) * plane_wave;
    };
    const WideLanes real = part(decay_, 0) * part(memory_, 0) - part(decay_, 1) * part(memory_, 1) + added(0);
    const WideLanes imaginary = part(decay_, 0) * part(memory_, 1) + part(decay_, 1) * part(memory_, 0) + added(1);
    put(last, &past_[i]);
    put(real, &memory_[0][i]);
    put(imaginary, &memory_[1][i]);
    put(plane_wave - (gain_.real() * real - gain_.imag() * imaginary), &pressure[i]);
  }
}

void SurfacePressure::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  if (root_ == 0.0) {
    return;
  }
  row.value(past_[triangle]);
  for (auto& part : memory_) {
    row.value(part[triangle]);
  }
}

}  // namespace idiophone::surface
