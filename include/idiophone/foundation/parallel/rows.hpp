#pragma once
// Rows that lie scattered over the ranks <-> one contiguous block of rows on each rank. Files hold rows in global
// order, so whatever a rank writes is one contiguous piece, and what was written on some ranks can be read on others.

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone::parallel {

/// Where each rank's rows belong in a table of global rows. A row is any number of values of one type; a row may stand
/// on several ranks if its content is the same there. Block r is the rows [global r / ranks, global (r+1) / ranks).
class Rows {
 public:
  /// Collective.
  /// @param numbers      global numbers of this rank's rows, in any order; a rank may have none
  /// @param global_rows  rows of the whole table
  /// @param communicator must outlive this object
  /// @throws std::runtime_error, on every rank, when a number is not in [0, global_rows) or a row is on no rank.
  Rows(std::span<const std::int32_t> numbers, std::int64_t global_rows, MPI_Comm communicator);

  [[nodiscard]] std::int64_t global_rows() const { return global_rows_; }
  [[nodiscard]] std::int64_t local_rows() const { return static_cast<std::int64_t>(order_.size()); }
  [[nodiscard]] std::int64_t block_begin() const { return block_begin_; }  ///< first global row of this rank's block
  [[nodiscard]] std::int64_t block_rows() const { return block_rows_; }    ///< rows in this rank's block
  [[nodiscard]] MPI_Comm communicator() const { return communicator_; }

  /// This rank's block, [width x block_rows()]. Collective.
  /// @param values  [width x local_rows()] in the order of `numbers`
  /// @throws std::runtime_error, on every rank, when the size is wrong or two ranks disagree about a row.
  template <class T>
  [[nodiscard]] std::vector<T> to_blocks(std::span<const T> values, int width) const {
    std::vector<T> block(block_rows_ * width);
    gather(std::as_bytes(values), std::as_writable_bytes(std::span(block)), sizeof(T) * width);
    return block;
  }

  /// This rank's rows, [width x local_rows()] in the order of `numbers`. Collective.
  /// @param block  [width x block_rows()]
  /// @throws std::runtime_error, on every rank, when the size is wrong.
  template <class T>
  [[nodiscard]] std::vector<T> from_blocks(std::span<const T> block, int width) const {
    std::vector<T> values(order_.size() * width);
    scatter(std::as_bytes(block), std::as_writable_bytes(std::span(values)), sizeof(T) * width);
    return values;
  }

 private:
  void sort_by_block(std::span<const std::int32_t> numbers, int ranks);
  void gather(std::span<const std::byte> values, std::span<std::byte> block, std::size_t row_bytes) const;
  void scatter(std::span<const std::byte> block, std::span<std::byte> values, std::size_t row_bytes) const;

  MPI_Comm communicator_;
  std::int64_t global_rows_;
  std::int64_t block_begin_ = 0, block_rows_ = 0;
  std::vector<std::size_t> order_;               // local rows, sorted by the rank whose block they belong to
  std::vector<int> send_counts_, send_offsets_;  // rows, by rank of the block
  std::vector<int> take_counts_, take_offsets_;  // rows, by rank that has them
  std::vector<std::size_t> places_;              // place in the block of each row taken
};

}  // namespace idiophone::parallel
