#pragma once
// Fractional delay: a sound that arrives between two entries of an accumulation buffer is spread over the entries
// around it, and filters turn entries into audio samples.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::receivers {

/// Weights of the entries around an arrival, for a sound and for its derivative with respect to time in audio samples,
/// and the filters that turn entries into audio samples. The weights are tabulated as Hermite cubics over the fraction
/// of an entry; the error is below 1e-8.
class Spreading {
 public:
  /// The paper's splat, one entry per audio sample, over four of them: a Gaussian with a standard deviation of half a
  /// sample (the paper's width of two samples is +-2 standard deviations), corrected so that the weights add up to one
  /// and their centroid is the arrival: w(n) = exp(-2 x^2) (a + b x), x = n - arrival. A plain sampled Gaussian would
  /// be up to 0.02 samples early or late. It has no derivative.
  [[nodiscard]] static const Spreading& splat();

  /// Two entries per audio sample and kaiser_bessel_spreading() over eight of them; entries_to_samples() corrects what
  /// this kernel loses and stops what lies above half the audio rate. Up to 0.45 of the rate (0.42 for sources that
  /// move at 20 m/s), level and delay are exact and false partials are below -98 dB. Constants and ramps are exact.
  [[nodiscard]] static const Spreading& band_limited();

  /// Number of entries that an arrival is spread over, a multiple of 4.
  [[nodiscard]] std::size_t width() const { return groups_ * lane_count; }

  /// Entries in an audio sample; the first of them is at the time of the sample.
  [[nodiscard]] std::size_t density() const { return filters_.size(); }

  /// The first entry of an arrival, relative to the last one that is not after the arrival.
  [[nodiscard]] std::int64_t first_entry() const { return 1 - static_cast<std::int64_t>(width() / 2); }

  /// The audio sample that the first entry of an arrival at audio sample 0 belongs to.
  [[nodiscard]] std::int64_t first() const {
    return -static_cast<std::int64_t>((width() / 2 - 1 + density() - 1) / density());
  }

  /// Whether there are weights of changes, for factors() and sum().
  [[nodiscard]] bool differentiates() const { return slope_ != 0.0; }

  /// An arrival as an entry, a cell of the table, and the position in the cell.
  struct ArrivalCell {
    std::int64_t before;  ///< last entry that is not after the arrival
    std::size_t cell;     ///< of the table
    double rest;          ///< in the cell, 0 to 1
  };

  /// @param arrival  in entries, 0 to 2^40
  [[nodiscard]] static ArrivalCell cell_of(double arrival) {
    const double place = arrival * cells;
    const auto cell = static_cast<std::int64_t>(place);
    return {cell >> cell_bits, static_cast<std::size_t>(cell & (cells - 1)), place - static_cast<double>(cell)};
  }

  /// The cells of four arrivals, which are found at once.
  struct ArrivalCells {
    std::array<std::int64_t, lane_count> before, cell;
    std::array<double, lane_count> rest;

    /// @param arrivals  in entries, 0 to 2^40
    explicit ArrivalCells(const Lanes4& arrivals) {
      const Lanes4 places = arrivals * static_cast<double>(cells);
      const auto found = __builtin_convertvector(places, IntegerLanes4);
      put(found >> cell_bits, before.data());
      put(found & (cells - 1), cell.data());
      put(places - __builtin_convertvector(found, Lanes4), rest.data());
    }
    [[nodiscard]] ArrivalCell operator[](std::size_t lane) const {
      return {before[lane], static_cast<std::size_t>(cell[lane]), rest[lane]};
    }
  };

  /// The weights of the entries around an arrival.
  class Weights {
   public:
    /// For the sound, of the entries that a vector of a group holds: of four lanes, those from first_entry() + 4 group
    /// on. The bits do not depend on the number of lanes, a divisor of width().
    template <class Lanes = Lanes4>
    [[nodiscard]] Lanes sound(const ArrivalCell& at, std::size_t group) const {
      const auto [a, b, c, d] = cubic<Lanes>(at, group);
      return a + at.rest * (b + at.rest * (c + at.rest * d));
    }
    /// What the coefficients of each power are multiplied by in the weighted sum of a sound and a change, for four
    /// arrivals. The weights of a change are the derivatives of the cubics.
    using Factors = std::array<std::array<double, lane_count>, 4>;
    [[nodiscard]] Factors factors(const ArrivalCells& at, const Lanes4& sounds, const Lanes4& changes) const {
      const auto rest = load(at.rest.data());
      const Lanes4 slopes = slope_ * changes;
      const Lanes4 more = slopes * rest;
      const Lanes4 first = sounds * rest + slopes;
      const Lanes4 second = rest * first + more;
      Factors factors;
      put(sounds, factors[0].data());
      put(first, factors[1].data());
      put(second, factors[2].data());
      put(rest * (second + more), factors[3].data());
      return factors;
    }
    /// The weighted sum of a sound and a change, for the entries as in sound().
    template <class Lanes = Lanes4>
    [[nodiscard]] Lanes sum(const ArrivalCell& at, std::size_t group, const Factors& factors, std::size_t lane) const {
      const auto [a, b, c, d] = cubic<Lanes>(at, group);
      return factors[0][lane] * a + factors[1][lane] * b + factors[2][lane] * c + factors[3][lane] * d;
    }

   private:
    friend class Spreading;
    Weights(const double* table, std::size_t width, double slope) : table_(table), width_(width), slope_(slope) {}

    /// Coefficients of the cubics of some entries.
    template <class Lanes>
    [[nodiscard]] std::array<Lanes, 4> cubic(const ArrivalCell& at, std::size_t group) const {
      const double* row = table_ + 4 * at.cell * width_ + group * (sizeof(Lanes) / sizeof(double));
      return {load<Lanes>(row), load<Lanes>(row + width_), load<Lanes>(row + 2 * width_),
              load<Lanes>(row + 3 * width_)};
    }

    const double* table_;  // as Spreading's
    std::size_t width_;
    double slope_;
  };

  /// Valid as long as this object. A copy of its own is faster in long loops, as nothing else can change it.
  [[nodiscard]] Weights weights() const { return {table_.data()->values.data(), width(), slope_}; }

  /// Filters from entries to audio samples, [density()][2 lookahead() + 1]. Audio sample n is the sum over d and k of
  /// filters[d][k] times entry d of the audio sample n + lookahead() - k.
  [[nodiscard]] const std::vector<std::vector<double>>& entries_to_samples() const { return filters_; }

  /// Audio samples that have to be final after one that is read.
  [[nodiscard]] std::size_t lookahead() const { return filters_.front().size() / 2; }

  /// A formula: [width] weights for an arrival at this fraction of an entry, which may lie a little outside 0 to 1.
  using Formula = std::function<std::vector<double>(double fraction)>;

 private:
  Spreading(std::size_t groups, const Formula& formula, std::vector<std::vector<double>> filters, double slope);

  static constexpr int cell_bits = 7;
  static constexpr int cells = 1 << cell_bits;  // in an entry
  std::size_t groups_;                          // of four entries
  std::vector<std::vector<double>> filters_;    // from entries to audio samples
  double slope_;                                // from a cubic's derivative to that with respect to time; 0: has none
  std::vector<AlignedBlock> table_;             // [cells][4 powers][width] coefficients, one after another
};

/// The splat's formula.
[[nodiscard]] std::vector<double> gaussian_splat(double fraction);

/// Eight samples of Kaiser and Bessel's window I0(20 sqrt(1 - (x/4)^2)), x in entries from the arrival, corrected as
/// the splat is. At 1.55 to 2.45 times the audio rate, which is what two entries per audio sample reflect into the
/// audible band, its spectrum is more than 100 dB below that of the band (Jackson et al. 1991; Barnett et al. 2019).
[[nodiscard]] std::vector<double> kaiser_bessel_spreading(double fraction);

}  // namespace idiophone::receivers
