#pragma once
// Filters between arrivals and the sound of an ear: head-related responses and atmospheric absorption.

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "idiophone/air/receivers/accumulation_buffer.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::receivers {

/// Finite impulse responses: [channels][taps].
using Responses = std::vector<std::vector<double>>;

/// The filters of a bank. Their numbers are chosen by the caller, from 0 up.
struct Filters {
  std::size_t channels = 1;   ///< of every filter
  std::size_t taps = 1;       ///< of every response
  std::size_t lookahead = 0;  ///< number of the tap with delay 0; the taps before it have negative delays
  std::function<Responses(std::int64_t number)>
      make;  ///< [channels][taps]; called on rank 0, once for each filter in use

  /// One filter, number 0: the identity.
  [[nodiscard]] static Filters none();
};

/// An accumulation buffer at the input of each filter in use, and the sum of the filters' outputs. The convolutions are
/// plain sums in one order, so the bits do not depend on how many audio samples are taken at once.
class FilterBank {
 public:
  /// @param first, longest_delay, spreading  as for an AccumulationBuffer
  FilterBank(std::int64_t first, double longest_delay, const Spreading& spreading, Filters filters);

  /// Adds to the input of a filter; see AccumulationBuffer::add. No communication.
  void add(std::int64_t filter, std::int64_t sample, const radiation::Arrivals& arrivals);

  /// Audio sample of the first sound that has not been taken.
  [[nodiscard]] std::int64_t first() const { return first_; }

  /// Audio samples that have to be final after one that is taken: those of the filters and of the spreading.
  [[nodiscard]] std::size_t lookahead() const { return filters_.lookahead + spreading_->lookahead(); }

  /// Removes the next `count` audio samples and returns their sum over the ranks. They are final as soon as all
  /// emissions up to lookahead() - spreading.first() samples after the last of them have been added. Collective.
  /// @return [channels][count] on rank 0, empty elsewhere
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count, MPI_Comm communicator);

  /// The state: first(), then for each filter its number, the length of its input, and the input as the coarse and
  /// fine integer of each entry. Collective.
  void archive(parallel::Archive& archive, const std::string& name);

 private:
  /// The input of one filter.
  struct FilterInput {
    AccumulationBuffer buffer;
    std::vector<FixedPoint> past;  // on rank 0: the last past_entries() entries before the buffer's first
    Responses responses;           // on rank 0, after their first use
  };
  /// Entries that the first audio sample to be taken needs from before the buffer's first.
  [[nodiscard]] std::size_t past_entries() const {
    return spreading_->density() * (filters_.taps - 1 + 2 * spreading_->lookahead());
  }
  [[nodiscard]] std::vector<std::int64_t> numbers_in_use(MPI_Comm communicator) const;
  /// The archive's words, summed over the ranks, on rank 0; empty elsewhere. Collective.
  [[nodiscard]] std::vector<std::int64_t> words(MPI_Comm communicator) const;
  /// Inputs from the words after first().
  void restore_inputs(std::span<const std::int64_t> words);
  FilterInput& input(std::int64_t number);

  std::int64_t first_;
  double longest_delay_;
  const Spreading* spreading_;
  Filters filters_;
  std::map<std::int64_t, FilterInput> inputs_;  // by the filter's number; ranks may differ in which they have
};

/// Audio samples from all their entries (see Spreading::entries_to_samples()), without the first and the last
/// lookahead() of them.
[[nodiscard]] std::vector<double> read_entries(const std::vector<double>& entries, const Spreading& spreading);

/// The output of a filter: sum_k taps[k] input[n + taps - 1 - k] for n from 0 on.
/// @param input  [taps - 1 + length of the result]
[[nodiscard]] std::vector<double> convolve(const std::vector<double>& input, const std::vector<double>& taps);

}  // namespace idiophone::receivers
