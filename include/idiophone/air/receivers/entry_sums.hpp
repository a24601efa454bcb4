#pragma once
// Sums of many sounds, each spread over the entries around its arrival.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/air/receivers/spreading.hpp"
#include "idiophone/foundation/parallel/reproducible_sum.hpp"

namespace idiophone::receivers {

/// Some arrivals of an emission, as radiation::Arrivals.
struct ArrivalBatch {
  std::span<const double> sounds, changes, delays;
};

/// Entries that a batch writes to; entry 0 is the first one of a sound without delay.
struct ReachedEntries {
  std::size_t begin, end;
};

/// @param delays  a multiple of 4, audio samples, 0 to 2^40
[[nodiscard]] ReachedEntries reached_entries(std::span<const double> delays, const Spreading& spreading);

/// Adds each tap as a whole number, so no sum depends on the order.
class EntrySums {
 public:
  /// @param reached  by the batch
  /// @param entries  from entry 0 on
  void add(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
           std::span<FixedPoint> entries);

 private:
  /// Sums of the reached entries that take turns: a processor waits where it reads what it wrote a moment ago.
  static constexpr std::size_t most_turns = 4;

  /// Of sounds that mostly reach the same entries.
  void add_near(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
                std::span<FixedPoint> entries);
  /// The only code that rounds taps, so that they have the same bits in any batch.
  template <class Lanes, bool with_changes>
  void sum(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached);

  std::vector<std::int64_t> coarse_, fine_;  // [turns][reached entries], kept for their memory
};

}  // namespace idiophone::receivers
