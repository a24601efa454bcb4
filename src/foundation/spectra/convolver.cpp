#include "idiophone/foundation/spectra/convolver.hpp"

#include <algorithm>

namespace idiophone::spectra {

Convolver::Convolver(std::vector<double> taps) : input_(2 * piece), tail_(piece), signal_(2 * piece), spectrum_(bins) {
  auto* bins_of_fftw = reinterpret_cast<fftw_complex*>(spectrum_.data());
  constexpr int size = 2 * static_cast<int>(piece);
  forwards_.reset(fftw_plan_dft_r2c_1d(size, signal_.data(), bins_of_fftw, FFTW_ESTIMATE));
  backwards_.reset(fftw_plan_dft_c2r_1d(size, bins_of_fftw, signal_.data(), FFTW_ESTIMATE));
  for (std::size_t first = piece; first < taps.size(); first += piece) {
    std::ranges::fill(signal_, 0.0);
    std::copy_n(&taps[first], std::min(piece, taps.size() - first), signal_.begin());
    const auto spectrum = transform();
    pieces_.emplace_back(spectrum.begin(), spectrum.end());
  }
  past_.assign(pieces_.size(), std::vector<Complex>(bins));
  taps.resize(std::min(piece, taps.size()));
  head_ = std::move(taps);
}

std::span<const Convolver::Complex> Convolver::transform() {
  fftw_execute(forwards_.get());
  return spectrum_;
}

double Convolver::step(double input) {
  input_[piece + place_] = input;
  double sum = tail_[place_];
  const double* newest = &input_[piece + place_];
  for (std::size_t k = 0; k < head_.size(); ++k) {
    sum += head_[k] * *(newest - k);
  }
  if (++place_ == piece) {
    finish_piece();
  }
  return sum;
}

void Convolver::finish_piece() {
  place_ = 0;
  if (!pieces_.empty()) {
    signal_ = input_;
    const auto spectrum = transform();
    newest_ = (newest_ + past_.size() - 1) % past_.size();
    std::ranges::copy(spectrum, past_[newest_].begin());
    std::ranges::fill(spectrum_, 0.0);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const std::vector<Complex>& past = past_[(newest_ + p) % past_.size()];
      for (std::size_t k = 0; k < bins; ++k) {
        spectrum_[k] += pieces_[p][k] * past[k];
      }
    }
    fftw_execute(backwards_.get());
    std::transform(signal_.begin() + piece, signal_.end(), tail_.begin(),
                   [](double sample) { return sample / (2.0 * piece); });
  }
  std::copy_n(input_.begin() + piece, piece, input_.begin());
}

}  // namespace idiophone::spectra
