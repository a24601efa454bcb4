#pragma once
// Numbers of a body's nodes, such as its part of a vector: whole on rank 0, in shares on the ranks that own the nodes.

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::motion {

/// Whole, a row of numbers stands for each node of the body, in the order of their global numbers. A share has the rows
/// of the body's nodes that a rank owns, in the part's order.
class BodyRows {
 public:
  /// Collective.
  /// @param width  numbers in a row
  BodyRows(const mesh::Part& part, const mesh::BodyPart& body, int width, MPI_Comm communicator);

  /// Numbers in all rows together: on rank 0 only.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Whether there is only one rank, whose share is the whole.
  [[nodiscard]] bool is_whole() const { return counts_.size() == 1; }

  /// Rank 0's rows to their owners. Collective.
  /// @param whole  [size()] on rank 0; ignored elsewhere
  /// @param own    [width x owned nodes of the body]
  void scatter(std::span<const double> whole, std::span<double> own) const;

  /// The owners' rows to rank 0. Collective.
  /// @param own    [width x owned nodes of the body]
  /// @param whole  [size()] on rank 0; ignored elsewhere
  void gather(std::span<const double> own, std::span<double> whole) const;

 private:
  MPI_Comm communicator_;
  std::size_t width_;
  parallel::Datatype row_;
  std::vector<int> counts_, offsets_;  ///< [ranks] rows of each rank, and where they begin
  std::vector<Index> places_;          ///< on rank 0: of the ranks' rows, one rank's after another's, in the whole;
                                       ///< empty where the share is the whole
  std::size_t size_ = 0;
};

}  // namespace idiophone::motion
