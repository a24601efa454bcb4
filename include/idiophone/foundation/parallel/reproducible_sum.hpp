#pragma once
// Sums of doubles that come out the same to the bit whatever the order of the terms and however they are spread over
// ranks: every term is cut, by itself, into two whole numbers, and whole numbers add up exactly.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace idiophone {

/// A number as coarse 2^-30 + fine 2^-70. In carried form (see carry) each value has one representation only.
struct FixedPoint {
  static constexpr double limit = 0x1p20;  ///< largest magnitude that can be cut
  static constexpr int carry_bits = 40;    ///< fine units in a coarse one: 2^40

  std::int64_t coarse = 0;
  std::int64_t fine = 0;

  /// Rounds a value of magnitude <= limit to the nearest 2^-70; larger ones give a wrong number.
  [[nodiscard]] static FixedPoint from(double value);

  /// Brings |fine| below 2^39, value unchanged. A cut value's fine part is not above 2^39, so 2^23 may be added
  /// between two carries.
  void carry() {
    const std::int64_t carried = (fine + (std::int64_t{1} << (carry_bits - 1))) >> carry_bits;
    coarse += carried;
    fine -= carried * (std::int64_t{1} << carry_bits);
  }

  FixedPoint& operator+=(const FixedPoint& other) {
    coarse += other.coarse;
    fine += other.fine;
    return *this;
  }

  /// The nearest double, to one rounding of each part. Of a carried number, so that it does not depend on its history.
  [[nodiscard]] double value() const {
    return static_cast<double>(coarse) * 0x1p-30 + static_cast<double>(fine) * 0x1p-70;
  }

  bool operator==(const FixedPoint&) const = default;
};

/// A double's (or each lane's) two whole numbers; |value| <= FixedPoint::limit. All of it is exact but the rounding of
/// the fine part.
template <class Integer, class Real>
struct Cut {
  Integer coarse, fine;

  explicit Cut(const Real& value) {
    // 1.5 2^52 units and a few more have the same exponent, and their last bit is one unit: the sum is rounded to whole
    // units, which are in its low bits. Vector code everywhere.
    constexpr double coarse_rounder = 0x1.8p52 * 0x1p-30, fine_rounder = 0x1.8p52 * 0x1p-70;
    const Real rounded = value + coarse_rounder;
    const Real rest = value - (rounded - coarse_rounder);
    coarse = std::bit_cast<Integer>(rounded) - std::bit_cast<std::int64_t>(coarse_rounder);
    fine = std::bit_cast<Integer>(rest + fine_rounder) - std::bit_cast<std::int64_t>(fine_rounder);
  }
};

inline FixedPoint FixedPoint::from(double value) {
  const Cut<std::int64_t, double> cut(value);
  return {cut.coarse, cut.fine};
}

/// A sum whose bits do not depend on the order of its terms. A term that is not finite or above FixedPoint::limit, or a
/// sum above 2^30, makes it invalid for good; its value is then NaN.
class ReproducibleSum {
 public:
  static constexpr double limit = 0x1p30;  ///< largest magnitude of the sum

  /// Adds one term.
  void add(double term) {
    if (!(std::abs(term) <= FixedPoint::limit)) {  // also true of NaN
      valid_ = false;
      return;
    }
    accept(FixedPoint::from(term));
  }

  /// Adds all terms of another sum.
  void merge(const ReproducibleSum& other) {
    valid_ = valid_ && other.valid_;
    accept(other.sum_);
  }

  [[nodiscard]] bool valid() const { return valid_; }

  /// The sum, or NaN.
  [[nodiscard]] double value() const { return valid_ ? sum_.value() : std::numeric_limits<double>::quiet_NaN(); }

  /// Whole numbers to add up over ranks (MPI_SUM of MPI_INT64_T, up to 2^20 ranks) and give to from_words.
  using Words = std::array<std::int64_t, 4>;
  [[nodiscard]] Words words() const { return {sum_.coarse >> 32, sum_.coarse & 0xffffffff, sum_.fine, valid_ ? 0 : 1}; }

  /// The sum of all the sums whose words were added up.
  [[nodiscard]] static ReproducibleSum from_words(const Words& words) {
    ReproducibleSum sum;
    const std::int64_t high = words[0] + (words[1] >> 32);
    sum.valid_ = words[3] == 0 && std::abs(high) <= (std::int64_t{1} << 28);
    if (sum.valid_) {
      sum.accept({high * (std::int64_t{1} << 32) + (words[1] & 0xffffffff), words[2]});
    }
    return sum;
  }

 private:
  void accept(const FixedPoint& term) {
    sum_ += term;
    sum_.carry();
    if (std::abs(sum_.coarse) > (std::int64_t{1} << 60)) {
      valid_ = false;
      sum_ = {};
    }
  }

  FixedPoint sum_;  // carried; |coarse| <= 2^60
  bool valid_ = true;
};

}  // namespace idiophone
