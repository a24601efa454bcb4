#include "idiophone/foundation/parallel/errors.hpp"

#include <gtest/gtest.h>

#include "idiophone/foundation/deck/location.hpp"
#include "ranks.hpp"

namespace idiophone::parallel {
namespace {

ON_RANKS(1, 2, 3, 4);

TEST(OnRoot, WorksOnRankZeroOnly) {
  int calls = 0;
  on_root(MPI_COMM_WORLD, [&] { ++calls; });
  EXPECT_EQ(calls, is_root(MPI_COMM_WORLD) ? 1 : 0);
}

TEST(OnRoot, AFailureReachesEveryRank) {
  const auto fail = [] { throw deck::DeckError({.file = "deck.yaml", .line = 1, .column = 2}, "wrong"); };
  if (is_root(MPI_COMM_WORLD)) {
    EXPECT_THROW(on_root(MPI_COMM_WORLD, fail), deck::DeckError);
    return;
  }
  try {
    on_root(MPI_COMM_WORLD, fail);
    FAIL() << "rank 0's failure was lost";
  } catch (const RemoteFailure& failure) {
    EXPECT_STREQ(failure.what(), "deck.yaml:1:2: wrong");
  }
}

}  // namespace
}  // namespace idiophone::parallel
