#include "remainder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "idiophone/foundation/spectra/transform.hpp"
#include "noise.hpp"

namespace idiophone::partials {

Bins spectrum_of(const LineSpectrum& line_spectrum, std::span<const double> samples) {
  std::vector<double> windowed(samples.begin(), samples.end());
  for (std::size_t n = 0; n < windowed.size(); ++n) {
    windowed[n] *= line_spectrum.window(n);
  }
  spectra::Transform transform(2 * samples.size());
  const auto bins = transform(windowed);
  return {bins.begin(), bins.end()};
}

Remainder::Remainder(const LineSpectrum& line_spectrum, std::span<const double> samples, const SearchOptions& options)
    : line_spectrum_(line_spectrum),
      options_(options),
      spectrum_(spectrum_of(line_spectrum, samples)),
      rest_(spectrum_),
      given_(samples.size() + 1) {
  for (std::size_t k = options.reported.begin; k < options.reported.end; ++k) {
    faintest_ = std::max(faintest_, std::norm(spectrum_[k]) / options.dynamic_range);
  }
}

void Remainder::add(const Line& line, double factor) {
  const Bins bins = line_spectrum_.spectrum(line, line_spectrum_.all());
  for (std::size_t k = 0; k < bins.size(); ++k) {
    rest_[k] += factor * bins[k];
  }
}

Bins Remainder::target(const std::vector<Line>& lines, BinRange band) const {
  Bins result(rest_.begin() + static_cast<std::ptrdiff_t>(band.begin),
              rest_.begin() + static_cast<std::ptrdiff_t>(band.end));
  for (const Line& line : lines) {
    std::ranges::transform(result, line_spectrum_.spectrum(line, band), result.begin(), std::plus<>());
  }
  return result;
}

std::vector<double> Remainder::noise() const {
  return noise_power(rest_, options_.noise_reach);
}

std::vector<double> Remainder::limits() const {
  std::vector<double> result = noise();
  for (double& power : result) {
    power = std::max(options_.prominence * power, faintest_);
  }
  return result;
}

double Remainder::highest(BinRange band) const {
  double result = 0.0;
  for (std::size_t k = band.begin; k < band.end; ++k) {
    result = std::max(result, std::abs(spectrum_[k]));
  }
  return result;
}

std::optional<std::size_t> Remainder::next_peak() {
  const std::vector<double> limit = limits();
  std::optional<std::size_t> strongest;
  for (std::size_t k = 0; k < rest_.size(); ++k) {
    const double power = std::norm(rest_[k]);
    const bool stronger = !strongest || power > std::norm(rest_[*strongest]);
    if (stronger && power > limit[k] && given_[k] == 0 && is_peak(k)) {
      strongest = k;
    }
  }
  if (strongest) {
    given_[*strongest] = 1;
  }
  return strongest;
}

/// Whether the remainder falls to half of this bin's amplitude on both sides before it rises above it. Ripples on the
/// flanks of lines whose fit is not final are no peaks.
bool Remainder::is_peak(std::size_t bin) const {
  const double power = std::norm(rest_[bin]);
  const auto turns = [&](double other) { return other > power || other < 0.25 * power; };
  const auto falls = [&](auto begin, auto end) {
    const auto turn = std::find_if(begin, end, [&](Complex other) { return turns(std::norm(other)); });
    return turn == end || std::norm(*turn) < power;
  };
  const auto here = rest_.begin() + static_cast<std::ptrdiff_t>(bin);
  return falls(here + 1, rest_.end()) && falls(std::make_reverse_iterator(here), rest_.rend());
}

Line Remainder::line_at(std::size_t peak) const {
  const double bin = line_spectrum_.bin();
  const double half = 0.5 * std::norm(rest_[peak]);
  std::size_t low = peak;
  std::size_t high = peak;
  while (low > 0 && std::norm(rest_[low]) > half) {
    --low;
  }
  while (high + 1 < rest_.size() && std::norm(rest_[high]) > half) {
    ++high;
  }
  const double width = std::max(static_cast<double>(high - low) - window_width, 0.5);
  Line line{.frequency = static_cast<double>(peak) * bin, .damping = 0.5 * width * bin, .amplitude = 1.0};
  line.amplitude = rest_[peak] / line_spectrum_.height(line);
  return line;
}

}  // namespace idiophone::partials
