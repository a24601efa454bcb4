#pragma once
// What is on its way to one receiver: the accumulation buffer of O'Brien 2001, section 3.3 and figure 4.

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/listening/spreading.hpp"
#include "idiophone/parallel/reproducible_sum.hpp"
#include "idiophone/radiation/radiation.hpp"

namespace idiophone::listening {

/// Entries over audio samples that sounds are added to when they are emitted and read from when they arrive. Sums are
/// exact, so neither the order of the triangles nor the ranks that they are on change a bit.
class AccumulationBuffer {
 public:
  /// @param first          audio sample of the first entry. The low-pass sounds before the motion begins, so this is to
  ///                       be 1 - latency + spreading.first() for emissions that begin at
  ///                       sample 1 - latency.
  /// @param longest_delay  in audio samples; longer ones are refused. radiation::longest_distance times
  ///                       Air::samples_per_metre().
  /// @param spreading      how an arrival is written; has to outlive the buffer
  AccumulationBuffer(std::int64_t first, double longest_delay, const Spreading& spreading)
      : first_(first), longest_delay_(longest_delay), spreading_(&spreading) {}

  /// An emission at audio sample i writes to entries from i + spreading.first() on: entries below are final once
  /// everything up to sample i has been added.
  ///
  /// Adds every sound emitted at `sample`, and the derivative of every change, spread about sample + delay.
  /// @throws std::runtime_error when a sound is not finite, all that is on its way may exceed FixedPoint::limit, or a
  ///         delay is negative or above longest_delay; std::logic_error when an entry before first() would be written,
  ///         or the spreading can't take derivatives.
  void add(std::int64_t sample, const radiation::Arrivals& arrivals);

  /// Audio sample of the first entry that was not taken.
  [[nodiscard]] std::int64_t first() const { return first_; }

  /// Moves the next `count` entries out; carried.
  [[nodiscard]] std::vector<FixedPoint> take(std::size_t count);

  /// All entries from first() on that have been written; carried.
  [[nodiscard]] std::vector<FixedPoint> pending() const;

  /// Takes the place of everything the buffer holds, e.g. by what pending() gave.
  void restore(std::int64_t first, std::vector<FixedPoint> entries);

 private:
  /// What one call of add() brings, or a part of it.
  struct Batch {
    std::span<const double> sounds, changes, delays;
  };
  void add_batch(std::int64_t sample, const Batch& batch);
  template <bool with_changes>
  void spread(const Batch& batch, FixedPoint* entries) const;
  void keep_in_range(std::int64_t sample, const Batch& batch);

  std::int64_t first_;
  double longest_delay_;
  const Spreading* spreading_;
  std::vector<FixedPoint> entries_;
  std::size_t added_ = 0;  // sounds since all entries were carried
  double bound_ = 0.0;     // no entry's magnitude is above this
};

/// Adds the ranks' entries up on rank 0, entry by entry; shorter vectors count as followed by zeros. Elsewhere the
/// result is empty. Collective. Up to 4096 ranks.
[[nodiscard]] std::vector<FixedPoint> sum_over_ranks(std::vector<FixedPoint> entries, MPI_Comm communicator);

/// The entries as doubles.
[[nodiscard]] std::vector<double> values(const std::vector<FixedPoint>& entries);

}  // namespace idiophone::listening
