#include "idiophone/timbre/export/tree_faust.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ranks.hpp"
#include "sounding.hpp"
#include "temporary_file.hpp"

namespace idiophone::timbre {

namespace {

std::string program_of(const std::string& tree) {
  const support::TemporaryFile file("tree.tt", tree);
  return faust_program(file.path());
}

}  // namespace

ON_RANKS(1);

TEST(Faust, HasSlidersForParametersThatMayChange) {
  const std::string program =
      program_of("(parameter n 3)(parameter amp -2)(parameter freq)(* amp (sine freq) (combine (rvector n 1 2)))");
  EXPECT_THAT(program, testing::HasSubstr(R"(hslider("amp", -2, -20, 20, 0.02))"));
  EXPECT_THAT(program, testing::HasSubstr(R"(hslider("freq", 1, 0, 10, 0.01))"));
  EXPECT_THAT(program, testing::Not(testing::HasSubstr(R"("n")")));
}

TEST(Faust, HasANoiseForEachSeed) {
  const std::string program = program_of("(+ (white) (white 1) (white 2) (combine (perlin (vector 1 2))))");
  EXPECT_THAT(program, testing::HasSubstr("no.noises(4, n)"));
  EXPECT_THAT(program, testing::HasSubstr("noise(3)"));
}

TEST(Faust, RefusesNodesThatNeedFiles) {
  EXPECT_THROW(static_cast<void>(program_of("(sample \"nothing.wav\")")), deck::DeckError);
  EXPECT_THROW(static_cast<void>(program_of("(sinee 440)")), deck::DeckError);
}

}  // namespace idiophone::timbre
