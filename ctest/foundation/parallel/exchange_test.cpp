// Broadcast, gather, reduction and messages, on as many ranks as the test is started with.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/messages.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "ranks.hpp"

namespace idiophone::parallel {
namespace {

/// The value on rank 0, another one elsewhere.
template <class Value>
Value only_on_root(const Value& value, const Value& elsewhere) {
  return is_root(MPI_COMM_WORLD) ? value : elsewhere;
}

ON_RANKS(1, 2, 3, 4);

TEST(Broadcast, NumbersListsAndTextsComeFromRoot) {
  EXPECT_EQ(from_root(only_on_root(2.5, -1.0), MPI_COMM_WORLD), 2.5);
  const std::vector<std::array<int, 2>> list = {{1, 2}, {3, 4}};
  EXPECT_EQ(from_root(only_on_root(list, {}), MPI_COMM_WORLD), list);
  EXPECT_EQ(from_root(only_on_root(std::string("bell"), std::string("wood block")), MPI_COMM_WORLD), "bell");
  const std::vector<std::string> texts = {"", "a", "long enough to be allocated by the string"};
  EXPECT_EQ(from_root(only_on_root(texts, {"b"}), MPI_COMM_WORLD), texts);
}

TEST(Broadcast, ComesFromTheRankAskedFor) {
  const int last = size_of(MPI_COMM_WORLD) - 1;
  std::string text = std::to_string(rank_of(MPI_COMM_WORLD));
  broadcast(text, MPI_COMM_WORLD, last);
  EXPECT_EQ(text, std::to_string(last));
}

TEST(Gather, OneValueOfEachRank) {
  const std::vector<int> all = gather(rank_of(MPI_COMM_WORLD), MPI_COMM_WORLD);
  ASSERT_EQ(std::ssize(all), size_of(MPI_COMM_WORLD));
  for (int rank = 0; rank < size_of(MPI_COMM_WORLD); ++rank) {
    EXPECT_EQ(all[rank], rank);
  }
}

TEST(Gather, ListsFollowOneAnotherAndMayBeEmpty) {
  const std::vector<double> own(rank_of(MPI_COMM_WORLD), 0.5 * rank_of(MPI_COMM_WORLD));  // rank 0 has none
  const Gathered<double> all = gather_all(std::span<const double>(own), MPI_COMM_WORLD);
  for (int rank = 0; rank < size_of(MPI_COMM_WORLD); ++rank) {
    EXPECT_EQ(all.counts[rank], rank);
    EXPECT_EQ(all.offsets[rank], rank * (rank - 1) / 2);
    for (int i = 0; i < rank; ++i) {
      EXPECT_EQ(all.values[all.offsets[rank] + i], 0.5 * rank);
    }
  }
}

TEST(Reduce, ExtremesAndSums) {
  const int last = size_of(MPI_COMM_WORLD) - 1;
  EXPECT_EQ(largest(rank_of(MPI_COMM_WORLD), MPI_COMM_WORLD), last);
  EXPECT_EQ(smallest(-0.5 * rank_of(MPI_COMM_WORLD), MPI_COMM_WORLD), -0.5 * last);
  EXPECT_EQ(sum(rank_of(MPI_COMM_WORLD), MPI_COMM_WORLD), last * (last + 1) / 2);
  std::array<float, 2> lowest = {1.0F, static_cast<float>(-rank_of(MPI_COMM_WORLD))};
  reduce(lowest, MPI_MIN, MPI_COMM_WORLD);
  EXPECT_EQ(lowest, (std::array{1.0F, static_cast<float>(-last)}));
  std::vector<std::int64_t> values = {1, rank_of(MPI_COMM_WORLD)};
  sum_on_root(std::span(values), MPI_COMM_WORLD);
  if (is_root(MPI_COMM_WORLD)) {
    EXPECT_EQ(values, (std::vector<std::int64_t>{last + 1, last * (last + 1) / 2}));
  } else {
    EXPECT_EQ(values, (std::vector<std::int64_t>{1, rank_of(MPI_COMM_WORLD)}));
  }
}

TEST(BackgroundGather, GathersAgainAndAgain) {
  std::vector<int> counts(size_of(MPI_COMM_WORLD));
  std::iota(counts.begin(), counts.end(), 0);  // rank 0 has nothing
  BackgroundGather<std::array<float, 2>> gather(counts, MPI_COMM_WORLD);
  for (const float round : {1.0F, 2.0F}) {
    gather.begin(std::vector(rank_of(MPI_COMM_WORLD), std::array{round, static_cast<float>(rank_of(MPI_COMM_WORLD))}));
    std::vector<std::array<float, 2>> expected;
    for (int rank = 0; rank < size_of(MPI_COMM_WORLD); ++rank) {
      expected.insert(expected.end(), rank, {round, static_cast<float>(rank)});
    }
    const auto all = gather.finish();
    EXPECT_TRUE(std::ranges::equal(all, expected));
  }
}

TEST(Messages, ReachTheNextRankWhateverTheirSize) {
  const int ranks = size_of(MPI_COMM_WORLD);
  const int next = (rank_of(MPI_COMM_WORLD) + 1) % ranks;
  const int previous = (rank_of(MPI_COMM_WORLD) + ranks - 1) % ranks;
  Messages messages(MPI_COMM_WORLD);
  // Too large to be buffered; rank 0's is empty.
  messages.send(std::vector(std::size_t{100000} * rank_of(MPI_COMM_WORLD), 1.5), next, 7);
  messages.send(std::vector{double(rank_of(MPI_COMM_WORLD))}, next, 8);
  messages.send(std::vector{std::array{1, rank_of(MPI_COMM_WORLD)}}, next, 9);
  EXPECT_EQ((messages.receive<std::array<int, 2>>(previous, 9)), (std::vector{std::array{1, previous}}));
  EXPECT_EQ(messages.receive<double>(previous, 8), std::vector<double>{double(previous)});
  EXPECT_EQ(messages.receive<double>(previous, 7), std::vector<double>(std::size_t{100000} * previous, 1.5));
}

}  // namespace
}  // namespace idiophone::parallel
