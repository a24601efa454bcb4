#pragma once
// Velocities of surfaces go to the ranks that have the air next to them, and its forces come back.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/air/waves/division.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/surface_coupling.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/messages.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::propagation {

/// Messages between ranks that are near: those of which one has cells of the grid at the surface that the other has.
class SurfaceExchange {
 public:
  /// Collective, as is the end.
  /// @param triangles  global numbers of those whose velocities this rank knows and whose forces it needs, ascending
  SurfaceExchange(const std::vector<Index>& triangles, MPI_Comm communicator);
  ~SurfaceExchange();
  SurfaceExchange(const SurfaceExchange&) = delete;
  SurfaceExchange& operator=(const SurfaceExchange&) = delete;
  SurfaceExchange(SurfaceExchange&&) = delete;
  SurfaceExchange& operator=(SurfaceExchange&&) = delete;

  /// Finds out which ranks are near, without communication.
  /// @param obstruction  on every rank the same
  void find_near(const waves::Obstruction& obstruction, const waves::Division& division);

  /// @param own  [triangles x 3 corners]
  /// @param all  [triangles of all ranks x 3 corners] those that are near this rank's cells are overwritten
  void send_velocities(std::span<const double> own, std::span<double> all) const;

  /// Adds up the shares of the ranks in the order of their cells: the sums do not depend on who has which cells.
  /// @param shares              of this rank's cells
  /// @param force, resistance   [triangles x 3 corners] overwritten; in the units of the shares
  void return_forces(const std::vector<waves::ForceShare>& shares, std::span<double> force,
                     std::span<double> resistance) const;

 private:
  [[nodiscard]] std::span<const Index> triangles_of(int rank) const {
    return std::span(triangles_.values).subspan(triangles_.offsets[rank], triangles_.counts[rank]);
  }

  [[nodiscard]] std::vector<waves::ForceShare> receive_shares(const parallel::Messages& messages) const;

  MPI_Comm communicator_ = MPI_COMM_NULL;  // its own, so that no other message is taken for one of these
  parallel::Gathered<Index> triangles_;    // of all ranks
  std::vector<int> cells_;                 // ranks with cells near this rank's surface
  std::vector<int> surfaces_;              // ranks with surfaces near this rank's cells
};

}  // namespace idiophone::propagation
