#include "shared_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "remainder.hpp"

namespace idiophone::partials {

namespace {

/// A line of amplitude 1 as two functions of time, e^(n s) and (n/length) e^(n s), each with a complex factor.
/// @param columns  [2 x bins, 4 or 2], real parts of the spectra, then imaginary parts
void put_functions(const LineSpectrum::Derivatives& derivatives, double length, Eigen::Ref<Eigen::MatrixXd> columns) {
  const auto put = [&](Eigen::Index column, const Bins& bins, double factor) {
    const Eigen::Map<const Eigen::VectorXcd> values(bins.data(), static_cast<Eigen::Index>(bins.size()));
    columns.col(column) << factor * values.real(), factor * values.imag();
  };
  put(0, derivatives.real, 1.0);
  put(1, derivatives.imaginary, 1.0);
  if (columns.cols() == 4) {
    put(2, derivatives.damping, -1.0 / length);
    put(3, derivatives.frequency, 1.0 / length);
  }
}

}  // namespace

SharedFit::SharedFit(const LineSpectrum& line_spectrum, const std::vector<std::vector<double>>& recordings,
                     std::vector<SharedLine> lines)
    : line_spectrum_(line_spectrum), lines_(std::move(lines)) {
  for (const std::vector<double>& samples : recordings) {
    rest_.push_back(spectrum_of(line_spectrum, samples));
  }
  for (SharedLine& line : lines_) {
    line.amplitude.assign(recordings.size(), 0.0);
  }
}

std::vector<SharedLine> SharedFit::fit() {
  // A group sees the flanks of all others, so the amplitudes come first.
  constexpr std::array passes = {Exponents::keep,    Exponents::keep,    Exponents::correct, Exponents::correct,
                                 Exponents::correct, Exponents::correct, Exponents::keep,    Exponents::keep};
  for (const Exponents exponents : passes) {
    join();
    fit_all(exponents);
  }
  return lines_;
}

void SharedFit::join() {
  constexpr double nearest = 0.1;  // of a bin or of the damping
  std::ranges::sort(lines_, {}, [](const SharedLine& shared) { return shared.line.frequency; });
  std::vector<SharedLine> joined;
  for (SharedLine& shared : lines_) {
    const Line& line = shared.line;
    const double least = nearest * std::max(line_spectrum_.bin(), line.damping);
    const bool is_same = !joined.empty() && std::hypot(line.frequency - joined.back().line.frequency,
                                                       line.damping - joined.back().line.damping) < least;
    if (!is_same) {
      joined.push_back(std::move(shared));
      continue;
    }
    add(shared, 1.0);  // what it had is found again in the next fit
  }
  lines_ = std::move(joined);
}

void SharedFit::fit_all(Exponents exponents) {
  const auto band_of = [&](std::size_t line) { return line_spectrum_.band_around(lines_[line].line); };
  for (std::size_t begin = 0; begin < lines_.size();) {
    std::size_t end = begin + 1;
    for (std::size_t reach = band_of(begin).end; end < lines_.size() && band_of(end).begin < reach; ++end) {
      reach = std::max(reach, band_of(end).end);
    }
    fit_group(std::span(lines_).subspan(begin, end - begin), exponents);
    begin = end;
  }
}

void SharedFit::fit_group(std::span<SharedLine> group, Exponents exponents) {
  for (const SharedLine& shared : group) {
    add(shared, 1.0);
  }
  const Eigen::MatrixXd found = factors(group, exponents);
  const Eigen::Index width = found.rows() / static_cast<Eigen::Index>(group.size());
  for (std::size_t j = 0; j < group.size(); ++j) {
    const auto own = found.middleRows(width * static_cast<Eigen::Index>(j), width);
    Complex product = 0.0;
    double power = 0.0;
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const auto factor = own.col(static_cast<Eigen::Index>(k));
      const Complex amplitude(factor[0], factor[1]);
      group[j].amplitude[k] = amplitude;
      power += std::norm(amplitude);
      product += width == 4 ? std::conj(amplitude) * Complex(factor[2], factor[3]) : 0.0;
    }
    const Complex wrong = power > 0.0 ? product / (power * static_cast<double>(line_spectrum_.length())) : 0.0;
    const double step = std::abs(wrong) > line_spectrum_.bin() ? line_spectrum_.bin() / std::abs(wrong) : 1.0;
    group[j].line.frequency += step * wrong.imag();
    group[j].line.damping -= step * wrong.real();
  }
  for (const SharedLine& shared : group) {
    add(shared, -1.0);
  }
}

Eigen::MatrixXd SharedFit::factors(std::span<const SharedLine> group, Exponents exponents) const {
  BinRange band = line_spectrum_.band_around(group.front().line);
  for (const SharedLine& shared : group) {
    const BinRange own = line_spectrum_.band_around(shared.line);
    band = {.begin = std::min(band.begin, own.begin), .end = std::max(band.end, own.end)};
  }
  const Eigen::Index width = exponents == Exponents::correct ? 4 : 2;
  const auto bins = static_cast<Eigen::Index>(band.size());
  Eigen::MatrixXd functions(2 * bins, width * static_cast<Eigen::Index>(group.size()));
  for (std::size_t j = 0; j < group.size(); ++j) {
    put_functions(line_spectrum_.derivatives(group[j].line, band), static_cast<double>(line_spectrum_.length()),
                  functions.middleCols(width * static_cast<Eigen::Index>(j), width));
  }
  Eigen::MatrixXd targets(2 * bins, static_cast<Eigen::Index>(rest_.size()));
  for (std::size_t k = 0; k < rest_.size(); ++k) {
    const Eigen::Map<const Eigen::VectorXcd> target(&rest_[k][band.begin], bins);
    targets.col(static_cast<Eigen::Index>(k)) << target.real(), target.imag();
  }
  return (functions.transpose() * functions).ldlt().solve(functions.transpose() * targets);
}

void SharedFit::add(const SharedLine& shared, double factor) {
  const Line& line = shared.line;
  const Bins cosine = line_spectrum_.spectrum({line.frequency, line.damping, 1.0}, line_spectrum_.all());
  const Bins sine = line_spectrum_.spectrum({line.frequency, line.damping, Complex(0.0, 1.0)}, line_spectrum_.all());
  for (std::size_t k = 0; k < rest_.size(); ++k) {
    const double real = factor * shared.amplitude[k].real();
    const double imaginary = factor * shared.amplitude[k].imag();
    for (std::size_t bin = 0; bin < cosine.size(); ++bin) {
      rest_[k][bin] += real * cosine[bin] + imaginary * sine[bin];
    }
  }
}

}  // namespace idiophone::partials
