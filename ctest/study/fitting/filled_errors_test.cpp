#include "filled_errors.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::ElementsAre;
using ::testing::IsNan;

const double missing = std::nan("");

ON_RANKS(1);

TEST(FilledErrors, AreTheLargerOfTheNextOnesBelowAndAbove) {
  EXPECT_THAT(filled_errors({0.1, missing, 0.3, missing, 0.2, missing, missing, 0.5}),
              ElementsAre(0.1, 0.3, 0.3, 0.3, 0.2, 0.5, 0.5, 0.5));
  EXPECT_THAT(filled_errors({missing, 2.0}), ElementsAre(2.0, 2.0));
  EXPECT_THAT(filled_errors({60.0, missing, 0.5, missing, 0.4}), ElementsAre(60.0, 60.0, 0.5, 0.5, 0.4));
}

TEST(FilledErrors, AboveTheHighestEstimateNothingIsKnown) {
  EXPECT_THAT(filled_errors({1.0, missing}), ElementsAre(1.0, IsNan()));
  EXPECT_THAT(filled_errors({missing, missing}), ElementsAre(IsNan(), IsNan()));
}

}  // namespace
}  // namespace idiophone::fitting
