#pragma once
// The spectrum of a damped sine, in closed form. All in units of samples.

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

namespace idiophone::partials {

using Complex = std::complex<double>;

/// x_n = Re(amplitude e^(n (i frequency - damping))), n from 0.
struct Line {
  double frequency = 0.0;  ///< radians per sample, in [0, pi]
  double damping = 0.0;    ///< 1 per sample
  Complex amplitude = 0.0;
};

/// Bins [begin, end) of a spectrum.
struct BinRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Values over the bins of a band.
using Bins = std::vector<Complex>;

/// Spectra of damped sines of one length under a falling half-Hann window w_n = cos^2(pi n/(2 length)), padded with
/// as many zeros: bin k = 0 ... length lies at pi k/length radians per sample.
///
/// The window keeps the loud beginning of a decaying sound and fades out its end. On this grid it
/// is a weighting of neighbouring bins by 1/4, 1/2, 1/4 of the unwindowed spectrum (1 - z^length)/(1 - z).
class LineSpectrum {
 public:
  explicit LineSpectrum(std::size_t length);

  [[nodiscard]] std::size_t length() const { return length_; }

  /// All bins: [0, length].
  [[nodiscard]] BinRange all() const { return {.begin = 0, .end = length_ + 1}; }

  /// Window of sample n.
  [[nodiscard]] double window(std::size_t n) const;

  /// Spectrum of a line in a band, its mirror image at negative frequencies included.
  [[nodiscard]] Bins spectrum(const Line& line, BinRange band) const;

  /// Its derivatives, for fitting.
  struct Derivatives {
    Bins real, imaginary;     ///< with respect to the real and imaginary part of the amplitude
    Bins frequency, damping;  ///< with respect to these
  };
  [[nodiscard]] Derivatives derivatives(const Line& line, BinRange band) const;

  /// Spectrum of a line at its own frequency, without the mirror image: its height, amplitude included.
  [[nodiscard]] double height(const Line& line) const;

  /// Where a line lies, bins.
  [[nodiscard]] double bin_of(const Line& line) const { return line.frequency / bin(); }

  /// Full width of a line at half power, bins.
  [[nodiscard]] double width_of(const Line& line) const { return 2.0 * std::abs(line.damping) / bin(); }

  /// The bins that a line is fitted to: twice its width on either side, and at least six widths of the narrowest line.
  [[nodiscard]] BinRange band_around(const Line& line) const;

  /// Width of a bin, radians per sample.
  [[nodiscard]] double bin() const { return std::numbers::pi / static_cast<double>(length_); }

 private:
  /// Sums over n with z = e^(exponent - i pi k/length), k in the band.
  struct Sums {
    Bins value;  ///< of w_n z^n
    Bins slope;  ///< of n w_n z^n; empty unless requested
  };
  enum class Requested { values, values_and_slopes };
  [[nodiscard]] Sums sums(Complex exponent, BinRange band, Requested requested) const;

  std::size_t length_;
  std::vector<Complex> turns_;  ///< [length + 3] e^(-i pi k/length), k from -1 to length + 1
};

}  // namespace idiophone::partials
