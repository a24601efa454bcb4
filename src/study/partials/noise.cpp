#include "noise.hpp"

#include <algorithm>
#include <numbers>

namespace idiophone::partials {
namespace {

constexpr std::size_t fewest = 80;  // bins on either side, for an accuracy of the median of about 10 %

double median(std::span<const double> values, std::vector<double>& work) {
  work.assign(values.begin(), values.end());
  const auto middle = work.begin() + static_cast<std::ptrdiff_t>(work.size() / 2);
  std::ranges::nth_element(work, middle);
  return *middle;
}

/// |d_k|^2, [bins]; a real sound's spectrum continues with its conjugate.
std::vector<double> roughness(std::span<const std::complex<double>> spectrum) {
  constexpr std::size_t step = 4;  // padded bins: two of the unpadded spectrum, where noise is independent
  const std::size_t last = spectrum.size() - 1;
  std::vector<double> result;
  for (std::size_t k = 0; k <= last; ++k) {
    const auto below = k >= step ? spectrum[k - step] : std::conj(spectrum[step - k]);
    const auto above = k + step <= last ? spectrum[k + step] : std::conj(spectrum[2 * last - k - step]);
    result.push_back(std::norm(spectrum[k] - 0.5 * (below + above)));
  }
  return result;
}

}  // namespace

std::vector<double> noise_power(std::span<const std::complex<double>> spectrum, std::size_t reach) {
  const std::size_t bins = spectrum.size();
  const std::vector<double> rough = roughness(spectrum);
  std::vector<double> result(bins);
  std::vector<double> work;
  // Noise varies slowly with frequency: one median per block of bins.
  for (std::size_t begin = 0; begin < bins;) {
    const std::size_t end = std::min(bins, begin + std::clamp(begin / 8, fewest / 4, std::max(reach / 2, fewest / 4)));
    const std::size_t centre = (begin + end) / 2;
    const std::size_t below = std::min(centre, std::max(std::min(centre / 2, reach), fewest));
    const std::size_t above = std::max(std::min(centre, reach), fewest);
    const std::size_t first = centre - below;
    const std::size_t last = std::min(bins, centre + above);
    const double mean = median(std::span(rough).subspan(first, last - first), work) / (1.5 * std::numbers::ln2);
    std::fill(result.begin() + static_cast<std::ptrdiff_t>(begin), result.begin() + static_cast<std::ptrdiff_t>(end),
              mean);
    begin = end;
  }
  return result;
}

}  // namespace idiophone::partials
