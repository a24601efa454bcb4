#pragma once
// What all ranks know, on every rank.

#include <mpi.h>

#include <algorithm>
#include <exception>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/datatype.hpp"

namespace idiophone::parallel {

/// Where each rank's values begin in a list of all ranks' values.
[[nodiscard]] inline std::vector<int> offsets_of(const std::vector<int>& counts) {
  std::vector<int> offsets(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), offsets.begin(), 0);
  return offsets;
}

/// All ranks' values, one rank's after another's.
template <class Value>
struct Gathered {
  std::vector<Value> values;
  std::vector<int> counts;   ///< [ranks] how many values
  std::vector<int> offsets;  ///< [ranks] where they begin
};

/// One value of each rank, [ranks]. Collective.
template <class Value>
[[nodiscard]] std::vector<Value> gather(const Value& value, MPI_Comm communicator) {
  const Datatype type = Datatype::of<Value>();
  std::vector<Value> all(size_of(communicator));
  MPI_Allgather(&value, 1, type.get(), all.data(), 1, type.get(), communicator);
  return all;
}

/// Any number of values of each rank. Collective.
template <class Value>
[[nodiscard]] Gathered<Value> gather_all(std::span<const Value> values, MPI_Comm communicator) {
  const Datatype type = Datatype::of<Value>();
  Gathered<Value> all;
  all.counts = gather(static_cast<int>(values.size()), communicator);
  all.offsets = offsets_of(all.counts);
  all.values.resize(all.offsets.back() + all.counts.back());
  MPI_Allgatherv(values.data(), static_cast<int>(values.size()), type.get(), all.values.data(), all.counts.data(),
                 all.offsets.data(), type.get(), communicator);
  return all;
}

/// Gathers the ranks' values while the computation goes on; always as many from a rank.
template <class Value>
class BackgroundGather {
 public:
  /// @param counts  [ranks] how many values
  BackgroundGather(std::vector<int> counts, MPI_Comm communicator)
      : communicator_(communicator),
        counts_(std::move(counts)),
        offsets_(offsets_of(counts_)),
        own_(counts_[rank_of(communicator)]),
        all_(offsets_.back() + counts_.back()) {}
  BackgroundGather(const BackgroundGather&) = delete;
  BackgroundGather& operator=(const BackgroundGather&) = delete;
  BackgroundGather(BackgroundGather&&) = delete;
  BackgroundGather& operator=(BackgroundGather&&) = delete;
  ~BackgroundGather() {
    // While an error takes the job down, the other ranks may never begin.
    if (std::uncaught_exceptions() == 0 || counts_.size() == 1) {
      wait();
    }
  }

  /// Begins to send this rank's values; waits for nobody. All ranks have to begin in the same order of all their
  /// collective calls.
  /// @param values  any range
  template <class Values>
  void begin(const Values& values) {
    std::ranges::copy(values, own_.begin());
    MPI_Iallgatherv(own_.data(), static_cast<int>(own_.size()), type_.get(), all_.data(), counts_.data(),
                    offsets_.data(), type_.get(), communicator_, &request_);
  }

  /// Waits until all ranks have begun.
  /// @return all ranks' values, one rank's after another's
  [[nodiscard]] std::span<const Value> finish() {
    wait();
    return all_;
  }

 private:
  void wait() {
    MPI_Wait(&request_, MPI_STATUS_IGNORE);  // NOLINT(clang-analyzer-optin.mpi.MPI-Checker): begin() made the request
  }

  MPI_Comm communicator_;
  std::vector<int> counts_, offsets_;
  std::vector<Value> own_, all_;
  Datatype type_ = Datatype::of<Value>();
  MPI_Request request_ = MPI_REQUEST_NULL;
};

}  // namespace idiophone::parallel
