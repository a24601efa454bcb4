#include "idiophone/foundation/parallel/rows.hpp"

#include <algorithm>
#include <numeric>

#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::parallel {

using namespace support;
namespace {

using ::testing::HasSubstr;

std::vector<std::int32_t> own_block(const Rows& rows) {
  std::vector<std::int32_t> numbers(rows.block_rows());
  std::iota(numbers.begin(), numbers.end(), static_cast<std::int32_t>(rows.block_begin()));
  return numbers;
}

ON_RANKS(1, 2, 3, 4);

TEST(Rows, BlocksAreContiguousAndComplete) {
  const Rows rows(dealt(103, 0), 103, MPI_COMM_WORLD);
  EXPECT_EQ(rows.block_begin(), 103 * rank() / ranks());
  EXPECT_EQ(rows.block_begin() + rows.block_rows(), 103 * (rank() + 1) / ranks());
}

TEST(Rows, ScatteredRowsReachTheirBlocksAndComeBack) {
  for (const int width : {1, 3}) {
    const auto numbers = dealt(103, 1);
    const Rows rows(numbers, 103, MPI_COMM_WORLD);
    const auto values = values_of(numbers, width);
    const auto block = rows.to_blocks(std::span(values), width);
    EXPECT_EQ(block, values_of(own_block(rows), width));
    EXPECT_EQ(rows.from_blocks(std::span(block), width), values);
  }
}

TEST(Rows, RanksMayHaveNoRows) {
  const auto numbers = all_on_last(5);
  const Rows rows(numbers, 5, MPI_COMM_WORLD);
  const std::vector<std::int64_t> values(numbers.begin(), numbers.end());
  const auto block = rows.to_blocks(std::span(values), 1);
  const auto expected = own_block(rows);
  EXPECT_TRUE(std::ranges::equal(block, expected));
  EXPECT_EQ(rows.from_blocks(std::span(block), 1), values);
}

TEST(Rows, FewerRowsThanRanks) {
  const Rows rows(all_on_last(1), 1, MPI_COMM_WORLD);
  const auto values = values_of(all_on_last(1), 2);
  EXPECT_EQ(rows.from_blocks(std::span<const double>(rows.to_blocks(std::span(values), 2)), 2), values);
}

TEST(Rows, NoRowsAtAll) {
  const Rows rows({}, 0, MPI_COMM_WORLD);
  EXPECT_TRUE(rows.to_blocks(std::span<const double>(), 3).empty());
}

TEST(Rows, MistakesOnOneRankReachAllRanks) {
  auto numbers = dealt(10, 0);
  if (rank() == ranks() - 1) {
    numbers.push_back(10);
  }
  EXPECT_THAT(error_of([&] { Rows(numbers, 10, MPI_COMM_WORLD); }), HasSubstr("row number 10 is outside of [0, 10)"));

  std::erase_if(numbers, [](auto row) { return row == 4 || row == 10; });
  EXPECT_THAT(error_of([&] { Rows(numbers, 10, MPI_COMM_WORLD); }), HasSubstr("row 4 of 10 is on no rank"));

  const Rows rows(dealt(10, 0), 10, MPI_COMM_WORLD);
  EXPECT_THAT(error_of([&] { return rows.to_blocks(std::span<const double>(std::vector<double>(99)), 1); }),
              HasSubstr("bytes given"));
}

TEST(Rows, RanksThatDisagreeAboutARowAreRefused) {
  const auto numbers = dealt(10, 0);  // row 9 is on every rank
  const Rows rows(numbers, 10, MPI_COMM_WORLD);
  auto values = values_of(numbers, 1);
  values[0] += rank();
  const auto message = error_of([&] { return rows.to_blocks(std::span<const double>(values), 1); });
  EXPECT_EQ(message.empty(), ranks() == 1);
}

}  // namespace
}  // namespace idiophone::parallel
