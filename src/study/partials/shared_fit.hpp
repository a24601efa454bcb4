#pragma once
// Damped sines with common frequencies and dampings, fitted to several recordings at once. All in units of samples.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "line.hpp"

namespace idiophone::partials {

/// A line that several recordings share. The amplitude of `line` is 1.
struct SharedLine {
  Line line;
  std::vector<Complex> amplitude;  ///< [recordings]
};

/// Gauss and Newton's method. In each recording a line is fitted as (A + B n) e^(n s): B shows by how much its exponent
/// s = i frequency - damping is wrong there. All recordings together correct s by sum(conj(A) B)/sum |A|^2, the least
/// squares for noise of the same level in all of them. Lines that overlap are fitted together.
class SharedFit {
 public:
  /// @param recordings  [recordings][line_spectrum.length()]
  /// @param lines       with frequencies and dampings to begin with, by ascending frequency
  SharedFit(const LineSpectrum& line_spectrum, const std::vector<std::vector<double>>& recordings,
            std::vector<SharedLine> lines);

  /// Fits all lines, some times over.
  [[nodiscard]] std::vector<SharedLine> fit();

 private:
  enum class Exponents { keep, correct };

  /// Makes one line of those that have come to lie on each other.
  void join();
  void fit_all(Exponents exponents);
  void fit_group(std::span<SharedLine> group, Exponents exponents);
  /// Least squares of the group's functions in the band of each recording, [functions x recordings].
  [[nodiscard]] Eigen::MatrixXd factors(std::span<const SharedLine> group, Exponents exponents) const;
  /// Adds a line to the rests of all recordings.
  void add(const SharedLine& line, double factor);

  const LineSpectrum& line_spectrum_;
  std::vector<SharedLine> lines_;
  std::vector<Bins> rest_;  // [recordings][bins] spectra minus the lines
};

}  // namespace idiophone::partials
