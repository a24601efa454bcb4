#pragma once
// The positions of all surface vertices on every rank, sent while the computation goes on.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/parallel/gather.hpp"
#include "idiophone/types.hpp"

namespace idiophone::hearing {

class SharedPositions {
 public:
  /// Collective.
  /// @param vertices  this rank's: global numbers; a vertex on two ranks has the same position on both
  SharedPositions(const std::vector<Index>& vertices, MPI_Comm communicator);
  ~SharedPositions();
  SharedPositions(const SharedPositions&) = delete;
  SharedPositions& operator=(const SharedPositions&) = delete;
  SharedPositions(SharedPositions&&) = delete;
  SharedPositions& operator=(SharedPositions&&) = delete;

  /// Of all ranks: one more than the highest global number.
  [[nodiscard]] std::size_t vertices() const { return count_; }

  /// Begins to send; waits for nobody. All ranks have to begin in the same order of all their collective calls.
  /// @param positions  [3 x this rank's vertices or more], m
  void begin(std::span<const double> positions);

  /// Waits until all ranks have begun.
  /// @param positions  [3 x global vertices], m
  void finish(std::span<float> positions);

 private:
  void wait();

  MPI_Comm communicator_;
  MPI_Datatype point_ = MPI_DATATYPE_NULL;
  parallel::Gathered<Index> vertices_;
  std::size_t count_;
  std::vector<float> own_, all_;  ///< [3 x this rank's, all ranks' vertices]
  MPI_Request request_ = MPI_REQUEST_NULL;
};

}  // namespace idiophone::hearing
