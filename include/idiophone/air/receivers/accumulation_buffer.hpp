#pragma once
// Sound that has been emitted and will arrive at one receiver: the accumulation buffer of O'Brien 2001, section 3.3 and
// figure 4.

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/air/receivers/entry_sums.hpp"
#include "idiophone/air/receivers/spreading.hpp"
#include "idiophone/foundation/parallel/reproducible_sum.hpp"

namespace idiophone::receivers {

/// As many entries per audio sample as the spreading's density. Sounds are added when they are emitted and read when
/// they arrive. Sums are exact, so they do not depend on the order of the triangles or on the partition.
class AccumulationBuffer {
 public:
  /// @param first          audio sample of the first entries. The low-pass responds before the motion begins: for
  ///                       emissions from sample 1 - latency on, this is 1 - latency + spreading.first().
  /// @param longest_delay  audio samples; add() throws for longer ones. Usually radiation::longest_distance times
  ///                       Medium::samples_per_metre().
  /// @param spreading      must outlive the buffer
  AccumulationBuffer(std::int64_t first, double longest_delay, const Spreading& spreading)
      : first_(first), longest_delay_(longest_delay), spreading_(&spreading) {}

  /// Adds every sound emitted at `sample`, and the derivative of every change, spread about sample + delay. An emission
  /// at audio sample i writes to entries of the audio samples from i + spreading.first() on. Entries before are final
  /// as soon as all emissions up to sample i have been added.
  /// @throws std::runtime_error if a sound is not finite, the sum may exceed FixedPoint::limit, or a delay is negative
  ///         or above longest_delay; std::logic_error if an audio sample before first() would be written, or the
  ///         spreading has no derivative.
  void add(std::int64_t sample, const radiation::Arrivals& arrivals);

  /// Audio sample of the first entries that have not been taken.
  [[nodiscard]] std::int64_t first() const { return first_; }

  /// Removes the entries of the next `count` audio samples and returns them; carried.
  [[nodiscard]] std::vector<FixedPoint> take(std::size_t count);

  /// All entries from first() on that have been written; carried.
  [[nodiscard]] std::vector<FixedPoint> pending() const;

  /// Replaces all entries, e.g. by those that pending() returned.
  void restore(std::int64_t first, std::vector<FixedPoint> entries);

 private:
  void add_batch(std::int64_t sample, const ArrivalBatch& batch);
  void keep_in_range(std::int64_t sample, const ArrivalBatch& batch);

  std::int64_t first_;
  double longest_delay_;
  const Spreading* spreading_;
  std::vector<FixedPoint> entries_;
  EntrySums sums_;
  std::size_t added_ = 0;  // sounds since all entries were carried
  double bound_ = 0.0;     // no entry's magnitude is above this
};

/// Sums the ranks' entries on rank 0; shorter vectors are padded with zeros. On other ranks the result is empty.
/// Collective. Up to 4096 ranks.
[[nodiscard]] std::vector<FixedPoint> sum_over_ranks(std::vector<FixedPoint> entries, MPI_Comm communicator);

/// The entries as doubles.
[[nodiscard]] std::vector<double> values(const std::vector<FixedPoint>& entries);

}  // namespace idiophone::receivers
