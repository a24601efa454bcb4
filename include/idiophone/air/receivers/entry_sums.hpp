#pragma once
// Sums of many sounds, each spread over the entries around its arrival.

#include <array>
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
  /// @param batch    a multiple of 4
  /// @param reached  by the batch
  /// @param entries  from entry 0 on
  void add(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
           std::span<FixedPoint> entries);

 private:
  /// Of sounds that mostly reach the same entries.
  /// @tparam used  as sum()
  template <std::size_t used>
  void add_near(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
                std::span<FixedPoint> entries);
  /// The only code that rounds taps, so that they have the same bits in any batch.
  /// @tparam used  of each four arrivals; the others are silent
  template <std::size_t width, bool with_changes, std::size_t used>
  void sum(const ArrivalBatch& batch, const Spreading& spreading, std::size_t begin);

  /// Whole numbers in one cache line.
  struct alignas(pack_size * sizeof(std::int64_t)) AlignedIntegers {
    std::array<std::int64_t, pack_size> values;
  };

  // Sums of the taps of arrivals in the same entry, a row of [width] for each such entry: rows that overlapped would
  // make the processor wait. Kept for their memory.
  std::vector<AlignedIntegers> coarse_, fine_;
};

}  // namespace idiophone::receivers
