#include "match.hpp"
#include "ranks.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace idiophone::fitting {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;

constexpr auto none = std::nullopt;

double sharp(double frequency, double cents) {
  return frequency * std::exp2(cents / 1200);
}

ON_RANKS(1);

TEST(Match, FindsMissingModesAndFalseLines) {
  const std::vector<Candidate> candidates = {{100}, {150}, {200}, {260}};
  const std::vector<double> lines = {sharp(100, 20), 170, sharp(200, -10), sharp(260, 5)};
  EXPECT_THAT(match(lines, candidates, 50).candidate, ElementsAre(Optional(0), none, Optional(2), Optional(3)));
}

TEST(Match, KeepsTheOrder) {
  const std::vector<Candidate> candidates = {{100}, {sharp(100, 30)}};
  // Each line is nearer to the first candidate.
  const std::vector<double> lines = {sharp(100, -5), sharp(100, 10)};
  EXPECT_THAT(match(lines, candidates, 50).candidate, ElementsAre(Optional(0), Optional(1)));
}

TEST(Match, APairIsOneLineOrTwo) {
  const std::vector<Candidate> candidates = {{100, 2}, {200}};
  EXPECT_THAT(match(std::vector{sharp(100, -3), sharp(100, 3), 200.0}, candidates, 50).candidate,
              ElementsAre(Optional(0), Optional(0), Optional(1)));
  const Matching one = match(std::vector{100.0, 200.0}, candidates, 50);
  EXPECT_THAT(one.candidate, ElementsAre(Optional(0), Optional(1)));
  EXPECT_NEAR(one.cost, 0, 1e-12) << "the pair's second mode is not missing";
  EXPECT_THAT(match(std::vector{99.9, 100.0, 100.1, 200.0}, candidates, 50).candidate,
              testing::Contains(none).Times(1));
}

TEST(Match, IsLimitedByTheTolerance) {
  const std::vector<Candidate> candidates = {{100}};
  EXPECT_THAT(match(std::vector{sharp(100, 49)}, candidates, 50).candidate, ElementsAre(Optional(0)));
  EXPECT_THAT(match(std::vector{sharp(100, 51)}, candidates, 50).candidate, ElementsAre(none));
}

TEST(Match, ModesOutsideTheLinesAreNotMissing) {
  const std::vector<Candidate> candidates = {{50}, {100}, {150}, {200}, {400}};
  EXPECT_NEAR(match(std::vector{100.0, 200.0}, candidates, 50).cost, 0.25, 1e-12);
}

}  // namespace
}  // namespace idiophone::fitting
