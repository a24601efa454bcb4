#pragma once
// The positions of all surface vertices on every rank, sent while the computation goes on.

#include <mpi.h>

#include <array>
#include <span>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::propagation {

class SharedPositions {
 public:
  /// Collective.
  /// @param vertices  this rank's: global numbers; a vertex on two ranks has the same position on both
  SharedPositions(const std::vector<Index>& vertices, MPI_Comm communicator);

  /// Of all ranks: one more than the highest global number.
  [[nodiscard]] std::size_t vertices() const { return count_; }

  /// Sends and waits for all ranks. Collective.
  /// @param positions  [this rank's vertices] m
  /// @return  [3 x global vertices] m
  [[nodiscard]] std::vector<float> share(std::span<const Vector3> positions);

  /// Begins to send; waits for nobody. All ranks have to begin in the same order of all their collective calls.
  /// @param positions  [3 x this rank's vertices or more], m
  void begin(std::span<const double> positions);

  /// Waits until all ranks have begun.
  /// @param positions  [3 x global vertices], m
  void finish(std::span<float> positions);

 private:
  using Point = std::array<float, 3>;  ///< m

  parallel::Gathered<Index> vertices_;
  std::size_t count_;
  std::vector<Point> own_;  ///< [this rank's vertices]
  parallel::BackgroundGather<Point> gather_;
};

}  // namespace idiophone::propagation
