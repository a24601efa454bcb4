#include "idiophone/foundation/spectra/transform.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::spectra {

Transform::Transform(std::size_t size) : input_(size), output_(size / 2 + 1) {
  // std::complex<double> is laid out as fftw_complex by both standards.
  auto* output = reinterpret_cast<fftw_complex*>(output_.data());  // NOLINT(*-reinterpret-cast)
  plan_.reset(fftw_plan_dft_r2c_1d(static_cast<int>(size), input_.data(), output, FFTW_ESTIMATE));
}

std::span<const std::complex<double>> Transform::operator()(std::span<const double> samples) {
  std::fill(std::ranges::copy(samples, input_.begin()).out, input_.end(), 0.0);
  fftw_execute(plan_.get());
  return output_;
}

std::vector<double> inverse_transform(std::vector<std::complex<double>> spectrum, std::size_t size) {
  std::vector<double> samples(size);
  auto* input = reinterpret_cast<fftw_complex*>(spectrum.data());  // NOLINT(*-reinterpret-cast): the same layout
  fftw_plan plan = fftw_plan_dft_c2r_1d(static_cast<int>(size), input, samples.data(), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  return samples;
}

void require_sound(std::span<const double> samples, double rate) {
  if (!(rate > 0.0) || !std::isfinite(rate)) {
    throw std::invalid_argument(fmt::format("the sample rate must be positive, it is {} Hz", rate));
  }
  const auto bad = std::ranges::find_if_not(samples, [](double sample) { return std::isfinite(sample); });
  if (bad != samples.end()) {
    throw std::invalid_argument(fmt::format("sample {} of {} is {}: the sound has to be finite throughout",
                                            bad - samples.begin(), samples.size(), *bad));
  }
}

}  // namespace idiophone::spectra
