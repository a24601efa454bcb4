// From expressions to nodes: names, arguments, widths, what is shared, and what is computed before the sound begins.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "sounding.hpp"

namespace idiophone::timbre {

namespace {

/// Nodes that compute samples.
std::size_t size_of(const std::string& text, const Bindings& bindings = {}) {
  return Graph(parse_tree(text, "t.tt"), bindings, {}).size();
}

double first_of(const std::string& text, const Bindings& bindings = {}, const SoundStart& sound_start = {}) {
  return sound_of(text, 1, bindings, sound_start).front();
}

}  // namespace

ON_RANKS(1);

TEST(GraphBuilder, KnowsTheWordsThatAreNumbers) {
  EXPECT_EQ(first_of("pi"), std::numbers::pi);
  EXPECT_EQ(first_of("rate", {}, {.rate = 8000}), 8000.0);
  EXPECT_EQ(first_of("-2.5e3"), -2500.0);
}

TEST(GraphBuilder, TakesAWordForANodeWithoutArguments) {
  EXPECT_EQ(sound_of("white", 100), sound_of("(white)", 100));
  EXPECT_EQ(mistakes_of("sine"), "t.tt:1:1: found 0 arguments; write (sine frequency [phase = 0])");
}

TEST(GraphBuilder, WantsTheNameOfANodeFirst) {
  for (const char* text : {"()", "(3 4)", "((sine 1) 2)", "(\"sine\" 1)"}) {
    EXPECT_EQ(mistakes_of(text), "t.tt:1:1: a list begins with the name of a node") << text;
  }
}

TEST(GraphBuilder, BindsParametersToTheirDefaultsOrToWhatIsGiven) {
  EXPECT_EQ(first_of("(parameter a 3) a"), 3.0);
  EXPECT_EQ(first_of("(parameter a 3) a", {{"a", number(7)}}), 7.0);
  EXPECT_EQ(first_of("(parameter a) (* a a)", {{"a", number(7)}}), 49.0);
}

TEST(GraphBuilder, SaysOnceWhatIsWrongWithAParameterThatIsUsedTwice) {
  EXPECT_EQ(mistakes_of("(parameter a) (+ a (* a time))"),
            "t.tt:1:1: the parameter 'a' has no default and is not given a value");
}

TEST(GraphBuilder, MakesOneNodeOfACurveThatIsUsedTwice) {
  const auto curve = std::make_shared<const Curve>(std::vector{0.0, 1.0}, std::vector{0.0, 1.0}, Interpolation::linear);
  const Bindings bindings = {{"a", {.value = curve, .where = {}}}};
  EXPECT_EQ(size_of("(parameter a) (* a a)", bindings), 2U);
}

TEST(GraphBuilder, NamesTheArgumentThatIsNoWordAndTheOneThatIsNoText) {
  EXPECT_EQ(mistakes_of("(keyframe 3 0 1)"), "t.tt:1:11: interpolation of (keyframe ...) is a word, found '3'");
  EXPECT_EQ(mistakes_of("(keyframe (linear) 0 1)"),
            "t.tt:1:11: interpolation of (keyframe ...) is a word, found a list");
  EXPECT_EQ(mistakes_of("(sample a)"), "t.tt:1:9: file of (sample ...) is a text in quotes, found 'a'");
}

TEST(GraphBuilder, NamesTheArgumentThatMustBeKnownBeforeTheSoundBegins) {
  EXPECT_EQ(
      mistakes_of("(combine (rvector (vector 1 2) 0 1))"),
      "t.tt:1:19: length of (rvector ...) is a number that does not change with time, found a vector of 2 numbers");
  EXPECT_EQ(mistakes_of("(combine (vector 1 (sine 3)))"),
            "t.tt:1:20: x of (vector ...) is a number that does not change with time, found a signal");
  EXPECT_EQ(mistakes_of("(fir time (sine (vector 1 2)))"),
            "t.tt:1:11: taps of (fir ...) is a vector that does not change with time, found a vector of 2 signals");
}

TEST(GraphBuilder, CountsArguments) {
  EXPECT_EQ(mistakes_of("(bandpass white 100)"), "t.tt:1:1: found 2 arguments; write (bandpass x frequency quality)");
  EXPECT_EQ(mistakes_of("(abs)"), "t.tt:1:1: found 0 arguments; write (abs x)");
  EXPECT_EQ(mistakes_of("(white 1 2)"), "t.tt:1:1: found 2 arguments; write (white [seed = 1])");
  EXPECT_EQ(first_of("(+ 1 2 3 4 5)"), 15.0);  // the last one repeats
}

TEST(GraphBuilder, GivesACallTheWidthOfItsWidestArgument) {
  EXPECT_EQ(first_of("(combine (* 2 (vector 1 10 100)))"), 222.0);
  EXPECT_EQ(first_of("(combine (+ (vector 1 2) (vector 10 20)))"), 33.0);
  EXPECT_EQ(mistakes_of("(vector 1 2)"),
            "t.tt:1:1: the sound is a vector of 2 numbers; add its components up by (combine ...)");
}

TEST(GraphBuilder, ComputesWhatDependsOnNumbersAlone) {
  EXPECT_EQ(size_of("(combine (* (vector 1 2 3) (sqrt 4)))"), 0U);
  EXPECT_EQ(first_of("(combine (* (vector 1 2 3) (sqrt 4)))"), 12.0);
  EXPECT_EQ(size_of("(white 1)"), 1U);                         // numbers, and time
  EXPECT_EQ(size_of("(parameter a 2) (sine (* a 220))"), 1U);  // a parameter that is a number is one
  EXPECT_EQ(mistakes_of("(+ time\n (sqrt -1))"), "t.tt:2:2: (sqrt ...) of these numbers is not finite");
}

TEST(GraphBuilder, SharesWhatIsEqualAndNothingElse) {
  EXPECT_EQ(size_of("(+ (sine 440) (sine 440 0))"), 2U);  // the default, written out
  EXPECT_EQ(size_of("(define a (sine 440)) (+ a (* 2 a) (sine (* 2 220)))"), 3U);
  EXPECT_EQ(size_of("(+ (keyframe linear 0 1 1 2) (keyframe hold 0 1 1 2))"), 3U);  // words make a difference
  EXPECT_EQ(size_of("(- (white 1) (white 2))"), 3U);
  EXPECT_EQ(size_of("(+ (sine 0 0.25) (sine -0.0 0.25))"), 3U);  // and the sign of zero
  EXPECT_NE(first_of("(- (sine 0 0.25) (sine 0 0.125))"), 0.0);
}

TEST(GraphBuilder, BuildsDefinitionsInAnyOrder) {
  EXPECT_EQ(first_of("(define b (* 2 a)) (define a 21) b"), 42.0);
  EXPECT_EQ(mistakes_of("(define a (* 2 c)) (define b (+ a 1)) (* a b)"), "t.tt:1:16: there is no 'c'");
}

TEST(GraphBuilder, NamesTheWholeCycleAndNotWhatLeadsToIt) {
  EXPECT_THAT(mistakes_of("(define a (+ b 1)) (define b (+ c 1)) (define c (abs b)) a"),
              testing::EndsWith("a cycle: b needs c needs b"));
}

TEST(GraphBuilder, SaysAllMistakesOfATree) {
  EXPECT_EQ(mistakes_of("(define a (+ b 1)) (define b (* a 2))\n(+ (keyframe cubicc 0 1)\n(lowpass white -3)\n"
                        "(sample \"none.wav\")\nfoo (* a (abs)))"),
            "t.tt:1:33: a cycle: a needs b needs a\n"
            "t.tt:2:4: the interpolation is linear, cubic or hold, not 'cubicc'\n"
            "t.tt:3:1: the frequency of a filter is between 0 and half the rate, not -3\n"
            "t.tt:4:1: none.wav: System error : No such file or directory.\n"
            "t.tt:5:1: there is no 'foo'\n"
            "t.tt:5:10: found 0 arguments; write (abs x)");
}

TEST(GraphBuilder, SuggestsEveryKindOfWord) {
  EXPECT_EQ(mistakes_of("(+ 1 rat)"), "t.tt:1:6: there is no 'rat' (did you mean 'rate'?)");
  EXPECT_EQ(mistakes_of("(define hammer 1) (+ 1 hamer)"), "t.tt:1:24: there is no 'hamer' (did you mean 'hammer'?)");
  EXPECT_EQ(mistakes_of("(+ 1 whit)"), "t.tt:1:6: there is no 'whit' (did you mean 'white'?)");
}

}  // namespace idiophone::timbre
