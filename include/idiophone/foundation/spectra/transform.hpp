#pragma once
// The Fourier transform of real samples, by FFTW.

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <fftw3.h>

namespace idiophone::spectra {

/// Real-to-complex transforms of one size. Making one is not thread-safe (FFTW's planner is not).
class Transform {
 public:
  /// @param size  samples to transform at a time
  explicit Transform(std::size_t size);

  /// X_k = sum_n x_n e^(-2 pi i k n/size).
  /// @param samples  [at most size], the rest counts as zeros
  /// @return [size / 2 + 1], valid until the next call
  std::span<const std::complex<double>> operator()(std::span<const double> samples);

 private:
  struct DestroyPlan {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };
  std::vector<double> input_;
  std::vector<std::complex<double>> output_;
  std::unique_ptr<fftw_plan_s, DestroyPlan> plan_;
};

/// The samples x_n = sum_k X_k e^(2 pi i k n/size) over all k, where X_(size - k) is the conjugate of X_k. It is not
/// thread-safe.
/// @param spectrum  [size / 2 + 1]
[[nodiscard]] std::vector<double> inverse_transform(std::vector<std::complex<double>> spectrum, std::size_t size);

/// Refuses samples and rates that no analysis can work with.
/// @throws std::invalid_argument for a sample that is not finite or a rate that is not positive.
void require_sound(std::span<const double> samples, double rate);

}  // namespace idiophone::spectra
