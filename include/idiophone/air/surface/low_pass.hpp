#pragma once
// The low-pass of eqs. 6-8, from reads to the audio rate, for many signals at once.

#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/air/surface/sampling.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::surface {

/// Where in time a read's value belongs.
enum class ReadTime {
  end,    ///< a value at the end of the read
  middle  ///< a mean over the read, whose loss of high frequencies the low-pass makes good
};

/// Windowed sinc whose outputs are one audio sample apart. An input is added to every output that it reaches, so no
/// past inputs are kept.
class LowPass {
 public:
  /// @param width  number of signals, a multiple of 8
  LowPass(const Sampling& sampling, ReadTime time, std::size_t width);

  /// State after the signals have had these values for ever: [width].
  void fill(std::span<const double> values);

  /// Adds a few reads of one pack, eight values at each pointer; `first` is the number of the first one within the
  /// audio sample.
  void add(std::size_t pack, std::span<const double* const> reads, int first);

  /// Moves the complete outputs out, [width], and goes on to the next audio sample.
  void take(std::span<double> values);

  /// Outputs that an input is added to.
  [[nodiscard]] std::size_t outputs() const { return outputs_; }

  /// Weights of the inputs of an audio sample: [reads][2 outputs]. The row of an input stands there twice. Where the
  /// oldest output has the place n, the weights of all places begin at outputs() - n.
  [[nodiscard]] const std::vector<double>& taps() const { return taps_; }

  /// What a signal's output has so far; the oldest output is number 0.
  [[nodiscard]] double& sum(std::size_t signal, std::size_t output);

  /// One signal's state: its outputs, oldest first.
  void archive(std::size_t signal, parallel::ArchiveRow& row);

 private:
  static constexpr std::size_t outputs_at_once = 4;

  std::size_t outputs_;
  std::size_t oldest_ = 0;  // place of the output that is completed first
  std::vector<double> taps_;
  std::vector<AlignedBlock> sums_;  // [packs][outputs] by place
};

}  // namespace idiophone::surface
