#include "idiophone/foundation/parallel/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::parallel {

namespace {

void check_size(std::size_t bytes, std::size_t expected, MPI_Comm communicator) {
  agree(communicator,
        bytes == expected ? "" : fmt::format("rows: {} bytes given where {} were expected", bytes, expected));
}

}  // namespace

Rows::Rows(std::span<const std::int32_t> numbers, std::int64_t global_rows, MPI_Comm communicator)
    : communicator_(communicator), global_rows_(global_rows), order_(numbers.size()) {
  collectively(communicator, [&] {
    for (const auto number : numbers) {
      if (number < 0 || number >= global_rows) {
        throw std::runtime_error(fmt::format("row number {} is outside of [0, {})", number, global_rows));
      }
    }
  });
  const int ranks = size_of(communicator);
  const int self = rank_of(communicator);
  block_begin_ = global_rows * self / ranks;
  block_rows_ = global_rows * (self + 1) / ranks - block_begin_;
  sort_by_block(numbers, ranks);

  take_counts_.resize(send_counts_.size());
  MPI_Alltoall(send_counts_.data(), 1, MPI_INT, take_counts_.data(), 1, MPI_INT, communicator);
  send_offsets_ = offsets_of(send_counts_);
  take_offsets_ = offsets_of(take_counts_);

  std::vector<std::int32_t> sent(numbers.size());
  std::ranges::transform(order_, sent.begin(), [&](auto row) { return numbers[row]; });
  std::vector<std::int32_t> taken(take_offsets_.back() + take_counts_.back());
  MPI_Alltoallv(sent.data(), send_counts_.data(), send_offsets_.data(), MPI_INT32_T, taken.data(), take_counts_.data(),
                take_offsets_.data(), MPI_INT32_T, communicator);
  places_.resize(taken.size());
  std::ranges::transform(taken, places_.begin(),
                         [&](auto row) { return static_cast<std::size_t>(row - block_begin_); });

  collectively(communicator, [&] {
    std::vector<char> there(block_rows_);
    for (const auto place : places_) {
      there[place] = 1;
    }
    if (const auto hole = std::ranges::find(there, 0); hole != there.end()) {
      throw std::runtime_error(
          fmt::format("row {} of {} is on no rank", block_begin_ + (hole - there.begin()), global_rows));
    }
  });
}

void Rows::sort_by_block(std::span<const std::int32_t> numbers, int ranks) {
  std::vector<int> block_of(numbers.size());
  send_counts_.resize(ranks);
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    block_of[row] = static_cast<int>(((numbers[row] + std::int64_t{1}) * ranks - 1) / global_rows_);
    ++send_counts_[block_of[row]];
  }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return block_of[a] < block_of[b]; });
}

void Rows::gather(std::span<const std::byte> values, std::span<std::byte> block, std::size_t row_bytes) const {
  check_size(values.size(), order_.size() * row_bytes, communicator_);
  if (row_bytes == 0) {
    return;  // a table without columns has no bytes to point to
  }
  std::vector<std::byte> sent(values.size());
  for (std::size_t row = 0; row < order_.size(); ++row) {
    std::memcpy(&sent[row * row_bytes], &values[order_[row] * row_bytes], row_bytes);
  }
  std::vector<std::byte> taken(places_.size() * row_bytes);
  const Datatype type = Datatype::bytes(row_bytes);
  MPI_Alltoallv(sent.data(), send_counts_.data(), send_offsets_.data(), type.get(), taken.data(), take_counts_.data(),
                take_offsets_.data(), type.get(), communicator_);

  collectively(communicator_, [&] {
    std::vector<char> there(block_rows_);
    for (std::size_t row = 0; row < places_.size(); ++row) {
      const auto* const source = &taken[row * row_bytes];
      auto* const target = &block[places_[row] * row_bytes];
      if (there[places_[row]] != 0 && std::memcmp(target, source, row_bytes) != 0) {
        throw std::runtime_error(fmt::format("row {} of {} differs between two ranks that both have it",
                                             block_begin_ + static_cast<std::int64_t>(places_[row]), global_rows_));
      }
      std::memcpy(target, source, row_bytes);
      there[places_[row]] = 1;
    }
  });
}

void Rows::scatter(std::span<const std::byte> block, std::span<std::byte> values, std::size_t row_bytes) const {
  check_size(block.size(), block_rows_ * row_bytes, communicator_);
  if (row_bytes == 0) {
    return;  // a table without columns has no bytes to point to
  }
  std::vector<std::byte> sent(places_.size() * row_bytes);
  for (std::size_t row = 0; row < places_.size(); ++row) {
    std::memcpy(&sent[row * row_bytes], &block[places_[row] * row_bytes], row_bytes);
  }
  std::vector<std::byte> taken(values.size());
  const Datatype type = Datatype::bytes(row_bytes);
  MPI_Alltoallv(sent.data(), take_counts_.data(), take_offsets_.data(), type.get(), taken.data(), send_counts_.data(),
                send_offsets_.data(), type.get(), communicator_);
  for (std::size_t row = 0; row < order_.size(); ++row) {
    std::memcpy(&values[order_[row] * row_bytes], &taken[row * row_bytes], row_bytes);
  }
}

}  // namespace idiophone::parallel
