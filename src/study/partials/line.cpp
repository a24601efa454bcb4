#include "line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::partials {
namespace {

/// The window, as weights of neighbouring bins; the result has two bins fewer.
Bins windowed(const Bins& unwindowed) {
  Bins result(unwindowed.empty() ? 0 : unwindowed.size() - 2);
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k] = 0.25 * unwindowed[k] + 0.5 * unwindowed[k + 1] + 0.25 * unwindowed[k + 2];
  }
  return result;
}

}  // namespace

LineSpectrum::LineSpectrum(std::size_t length) : length_(length), turns_(length + 3) {
  for (std::size_t k = 0; k < turns_.size(); ++k) {
    turns_[k] = std::polar(1.0, -std::numbers::pi * (static_cast<double>(k) - 1.0) / static_cast<double>(length));
  }
}

double LineSpectrum::window(std::size_t n) const {
  const double cosine = std::cos(0.5 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(length_));
  return cosine * cosine;
}

LineSpectrum::Sums LineSpectrum::sums(Complex exponent, BinRange band, Requested requested) const {
  const bool with_slope = requested == Requested::values_and_slopes;
  const auto length = static_cast<double>(length_);
  const Complex first = std::exp(exponent);
  const Complex last = std::exp(length * exponent);
  Sums plain{.value = Bins(band.size() + 2), .slope = Bins(with_slope ? band.size() + 2 : 0)};
  for (std::size_t k = 0; k < band.size() + 2; ++k) {
    const Complex z = first * turns_[band.begin + k];
    const Complex end = (band.begin + k) % 2 == 0 ? -last : last;  // z^length; the table starts at bin -1
    const double square = std::norm(1.0 - z);
    const bool limit = square * length * length < 1e-10;  // 0/0: the first term of the series
    const Complex inverse = std::conj(1.0 - z) / square;
    plain.value[k] = limit ? length : (1.0 - end) * inverse;
    if (with_slope) {
      plain.slope[k] = limit ? 0.5 * length * (length - 1.0) : (z * plain.value[k] - length * end) * inverse;
    }
  }
  return {.value = windowed(plain.value), .slope = windowed(plain.slope)};
}

Bins LineSpectrum::spectrum(const Line& line, BinRange band) const {
  const Bins direct = sums(Complex(-line.damping, line.frequency), band, Requested::values).value;
  const Bins mirror = sums(Complex(-line.damping, -line.frequency), band, Requested::values).value;
  Bins result(band.size());
  for (std::size_t k = 0; k < band.size(); ++k) {
    result[k] = 0.5 * (line.amplitude * direct[k] + std::conj(line.amplitude) * mirror[k]);
  }
  return result;
}

LineSpectrum::Derivatives LineSpectrum::derivatives(const Line& line, BinRange band) const {
  const Sums direct = sums(Complex(-line.damping, line.frequency), band, Requested::values_and_slopes);
  const Sums mirror = sums(Complex(-line.damping, -line.frequency), band, Requested::values_and_slopes);
  Derivatives result;
  for (std::size_t k = 0; k < band.size(); ++k) {
    const Complex slope = 0.5 * line.amplitude * direct.slope[k];
    const Complex mirror_slope = 0.5 * std::conj(line.amplitude) * mirror.slope[k];
    result.real.push_back(0.5 * (direct.value[k] + mirror.value[k]));
    result.imaginary.push_back(Complex(0.0, 0.5) * (direct.value[k] - mirror.value[k]));
    result.frequency.push_back(Complex(0.0, 1.0) * (slope - mirror_slope));
    result.damping.push_back(-(slope + mirror_slope));
  }
  return result;
}

BinRange LineSpectrum::band_around(const Line& line) const {
  constexpr double narrowest_reach = 12.0;  // bins
  const double reach = std::max(narrowest_reach, 2.0 * width_of(line));
  const auto last = static_cast<double>(length_);
  return {.begin = static_cast<std::size_t>(std::clamp(bin_of(line) - reach, 0.0, last - narrowest_reach)),
          .end = static_cast<std::size_t>(std::clamp(bin_of(line) + reach, narrowest_reach, last)) + 1};
}

double LineSpectrum::height(const Line& line) const {
  const Sums own = sums(-line.damping, {.begin = 0, .end = 1}, Requested::values);
  return 0.5 * std::abs(line.amplitude * own.value[0]);
}

}  // namespace idiophone::partials
