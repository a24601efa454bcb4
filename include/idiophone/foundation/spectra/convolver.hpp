#pragma once
// Convolution with a long response, by FFTW, without latency.

#include <fftw3.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace idiophone::spectra {

/// The first taps are summed as they are, the others in pieces by Fourier transforms (uniformly partitioned
/// overlap-save).
class Convolver {
 public:
  static constexpr std::size_t piece = 128;  ///< taps

  explicit Convolver(std::vector<double> taps);

  /// The present piece of the input, and so many whole ones before it, decide the future.
  [[nodiscard]] std::size_t remembered_pieces() const { return pieces_.size() + 1; }

  /// The next sample of the output.
  double step(double input);

 private:
  static constexpr std::size_t bins = piece + 1;  // of a transform of two pieces
  using Complex = std::complex<double>;
  struct DestroyPlan {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };

  void finish_piece();
  /// The spectrum of `signal_`.
  std::span<const Complex> transform();

  std::vector<double> head_;                  // the first taps
  std::vector<std::vector<Complex>> pieces_;  // [pieces][bins] spectra of the other taps
  std::vector<std::vector<Complex>> past_;    // [pieces][bins] spectra of the input, a ring
  std::size_t newest_ = 0;                    // in past_
  std::vector<double> input_;                 // [2 piece] the piece before and the present one
  std::vector<double> tail_;                  // [piece] what the other taps add to the present piece
  std::size_t place_ = 0;                     // in the present piece
  std::vector<double> signal_;                // [2 piece]
  std::vector<Complex> spectrum_;             // [bins]
  std::unique_ptr<fftw_plan_s, DestroyPlan> forwards_, backwards_;
};

}  // namespace idiophone::spectra
