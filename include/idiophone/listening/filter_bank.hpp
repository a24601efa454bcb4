#pragma once
// Sounds that are filtered on their way to an ear: by the head that they come round, by the air that they cross.

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "idiophone/listening/accumulation_buffer.hpp"
#include "idiophone/parallel/archive.hpp"

namespace idiophone::listening {

/// Finite impulse responses: [channels][taps].
using Responses = std::vector<std::vector<double>>;

/// The filters of a bank. Whoever uses them numbers them as they like, from 0 up.
struct Filters {
  std::size_t channels = 1;   ///< that every filter has
  std::size_t taps = 1;       ///< in every response
  std::size_t lookahead = 0;  ///< number of the tap that leaves a sound at its time; those before it make it earlier
  std::function<Responses(std::int64_t number)> make;  ///< [channels][taps]; asked on rank 0, once for each in use

  /// One filter, number 0, that changes nothing.
  [[nodiscard]] static Filters none();
};

/// An accumulation buffer before each filter in use, and the sum of what comes out of the filters. The convolutions are
/// plain sums, always in the same order, so that no bit depends on how many audio samples are taken at once.
class FilterBank {
 public:
  /// The first three as for an AccumulationBuffer.
  FilterBank(std::int64_t first, double longest_delay, const Spreading& spreading, Filters filters);

  /// Adds to the buffer before a filter; see AccumulationBuffer::add. No communication.
  void add(std::int64_t filter, std::int64_t sample, const radiation::Arrivals& arrivals);

  /// Audio sample of the first sound that was not taken.
  [[nodiscard]] std::int64_t first() const { return first_; }

  /// Moves the next `count` audio samples out, summed over the ranks. They are final once everything emitted up to
  /// `lookahead` - spreading.first() after the last of them has been added. Collective.
  /// @return [channels][count] on rank 0, nothing elsewhere
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count, MPI_Comm communicator);

  /// All that decides the future: first(), then for each filter its number, the length of its input, and the input:
  /// coarse and fine of each entry. Collective.
  void archive(parallel::Archive& archive, const std::string& name);

 private:
  /// What goes into one filter.
  struct FilterInput {
    AccumulationBuffer buffer;
    std::vector<FixedPoint> past;  // on rank 0: the entries before the buffer's first that the filter still needs
    Responses responses;           // on rank 0, once they are needed
  };
  [[nodiscard]] std::vector<std::int64_t> numbers_in_use(MPI_Comm communicator) const;
  /// The archive's words, summed over the ranks, on rank 0; nothing elsewhere. Collective.
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

/// sum_k taps[k] line[n + taps - 1 - k] for n from 0 on: what comes out of a filter.
/// @param line  [taps - 1 + length of the result]
[[nodiscard]] std::vector<double> convolve(const std::vector<double>& line, const std::vector<double>& taps);

}  // namespace idiophone::listening
