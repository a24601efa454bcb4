#include "idiophone/timbre/language/graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "ranks.hpp"
#include "sounding.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Graphs, NameWhatIsNotThere) {
  EXPECT_EQ(mistakes_of("(sin 1)\n(sinne 440)"),
            "t.tt:2:1: there is a sound already; a tree has one, after its "
            "parameters and definitions");
  EXPECT_EQ(mistakes_of("(sinee 440)"), "t.tt:1:2: there is no node 'sinee' (did you mean 'sine'?)");
  EXPECT_EQ(mistakes_of("(parameter volume 1)(* volum time)"),
            "t.tt:1:24: there is no 'volum' (did you mean 'volume'?)");
  EXPECT_EQ(mistakes_of("(parameter a)(* a time)"),
            "t.tt:1:1: the parameter 'a' has no default and is not given a value");
  EXPECT_EQ(mistakes_of("(parameter amp 1) amp", {{"ampp", number(1)}}),
            "s.yaml:1:1: t.tt has no parameter 'ampp' (did you mean 'amp'?)");
}

TEST(Graphs, CheckTypesBeforeTheySound) {
  EXPECT_EQ(mistakes_of("(rvector time 1 2)"),
            "t.tt:1:10: length of (rvector ...) is a number that does not change with time, found a signal");
  EXPECT_EQ(mistakes_of("(sine (vector 1 2))"),
            "t.tt:1:1: the sound is a vector of 2 signals; add its components up by (combine ...)");
  EXPECT_EQ(mistakes_of("(combine (+ (vector 1 2) (sine (vector 1 2 3))))"),
            "t.tt:1:10: (+ ...) has arguments of 2 and of 3 components");
  EXPECT_EQ(mistakes_of("(sine)"), "t.tt:1:1: found 0 arguments; write (sine frequency [phase = 0])");
  EXPECT_EQ(mistakes_of("(abs 1 2)"), "t.tt:1:1: found 2 arguments; write (abs x)");
  EXPECT_EQ(mistakes_of("(sine \"a\")"), "t.tt:1:7: expected a number, a name or a list, found \"a\"");
  EXPECT_EQ(mistakes_of("(fir time time)"),
            "t.tt:1:11: taps of (fir ...) is a vector that does not change with time, found a signal");
  EXPECT_EQ(mistakes_of("(/ 1 0)"), "t.tt:1:1: (/ ...) of these numbers is not finite");
}

TEST(Graphs, FindEveryMistake) {
  EXPECT_EQ(mistakes_of("(define unused (nothing))\n(+ (cosinus 1)\n   (abs))"),
            "t.tt:1:17: there is no node 'nothing'\nt.tt:2:5: there is no node 'cosinus'\n"
            "t.tt:3:4: found 0 arguments; write (abs x)");
}

TEST(Graphs, RefuseCycles) {
  EXPECT_THAT(mistakes_of("(define a (+ b 1))(define b (* a 2)) a"), testing::EndsWith("a cycle: a needs b needs a"));
  EXPECT_THAT(mistakes_of("(define a (+ a 1)) 1"), testing::EndsWith("a cycle: a needs a"));
}

TEST(Graphs, ComputeEqualSubtreesOnceAndConstantsNever) {
  const auto size = [](const char* text) { return Graph(parse_tree(text, "t.tt"), {}, {}).size(); };
  EXPECT_EQ(size("(* (sine 440) (sine 440))"), 2U);
  EXPECT_EQ(size("(+ (sine 440) (sine (* 2 220)) (sine 441))"), 3U);
  EXPECT_EQ(size("(sqrt (+ 1 (* 2 pi)))"), 0U);
  EXPECT_EQ(size("(- white (white 1))"), 2U);
}

TEST(Graphs, SoundTheSameForAnyDivisionIntoBlocks) {
  const std::string tree =
      "(define f (rvector 7 300 4000))\n"
      "(define modes (combine (* (damp f 0.001) (sine f)) (vector 1 2 3 4 5 6 7)))\n"
      "(define noise (+ (pink) (perlin 50) (markov 3) (white 4)))\n"
      "(define waves (+ (sawtooth (+ 500 (* 9 (markov 2)))) (square 300) (triangle (* 700 (perlin 2)))))\n"
      "(+ modes (bandpass noise 900 4) (delay waves (+ 0.01 (* 0.005 (sine 3)))) (reverberate modes 0.4)\n"
      "   (timer 0.01 0.05 (keyframe cubic 0 0 0.02 1 0.06 0)) (lowpass waves 800) (fir noise (vector 1 2 1)))";
  const std::vector<double> whole = sound_of(tree, 5000);
  for (const std::size_t length : {1U, 7U, 64U, 1000U}) {
    Graph graph(parse_tree(tree, "t.tt"), {}, {});
    std::vector<double> sound(5000);
    for (std::size_t begin = 0; begin < sound.size(); begin += length) {
      graph.render(std::span(sound).subspan(begin, std::min(length, sound.size() - begin)));
    }
    EXPECT_EQ(sound, whole) << length;
  }
}

TEST(Graphs, SayWhichNodeIsNotFinite) {
  try {
    static_cast<void>(sound_of("(+ 1\n   (log (- 0.5 time)))", 44100));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "t.tt:2:4: (log ...) is not finite 0.5 s after the sound began; its arguments are out "
                 "of range (docs/method/timbre.md)");
  }
}

TEST(Graphs, BindParametersToFunctionsOfTheScenesTime) {
  const auto curve = std::make_shared<const Curve>(std::vector<double>{1.0, 2.0}, std::vector<double>{10.0, 20.0},
                                                   timbre::Interpolation::linear);
  const Bindings bindings = {{"a", {.value = curve, .where = {}}}};
  EXPECT_NEAR(sound_of("(parameter a 3) a", 4411, bindings, {.start = 1.5}).back(), 16.0, 1e-9);
  EXPECT_EQ(sound_of("(parameter a 3) a", 1).front(), 3.0);
  EXPECT_EQ(mistakes_of("(parameter n 3) (combine (rvector n 1 2))", {{"n", {.value = curve, .where = {}}}}),
            "t.tt:1:35: length of (rvector ...) is a number that does not change with time, found a signal");
}

namespace {

/// When a sound ends, s; -1 if it does not within 20 s.
double end_of(const std::string& text, const Bindings& bindings = {}) {
  constexpr int rate = 8000;
  Graph graph(parse_tree(text, "t.tt"), bindings, {.rate = rate});
  std::vector<double> sound(80);  // 0.01 s
  for (int i = 1; i <= 2000; ++i) {
    graph.render(sound);
    if (graph.has_ended()) {
      return 0.01 * i;
    }
  }
  return -1.0;
}

}  // namespace

TEST(Graphs, EndsWhereNothingExcitesASoundAnyMore) {
  const double mode = 9.0 * std::log(10.0) / (2.0 * std::numbers::pi * 440.0 * 0.002);  // to 1e-9: 3.75 s
  EXPECT_NEAR(end_of("(* 0.1 (damp 440 0.002) (sine 440))"), mode, 0.02);
  EXPECT_NEAR(end_of("(combine (* (damp (vector 440 880) 0.002) (sine (vector 440 880))) (vector 1 2))"), mode, 0.02);
  EXPECT_NEAR(end_of("(timer 0.5 1.5 white)"), 1.5, 0.02);
  EXPECT_NEAR(end_of("(* white (keyframe linear 0 1 0.7 0))"), 0.7, 0.02);
  EXPECT_NEAR(end_of("(delay (timer 0 0.1 white) 0.8)"), 1.9, 0.05);  // a second after its last sample
  EXPECT_NEAR(end_of("(+ (timer 0 0.1 white) (abs (timer 0 0.3 white)))"), 0.3, 0.02);
  EXPECT_EQ(end_of("0"), 0.01);
  const double ring = 9.0 * std::log(10.0) * 20.0 / (std::numbers::pi * 300.0);  // of the resonance: 0.44 s
  EXPECT_NEAR(end_of("(bandpass (timer 0 0.1 1) 300 20)"), 0.1 + ring, 0.1);
  const auto knock = std::make_shared<const Curve>(std::vector{0.0, 0.2}, std::vector{1.0, 0.0}, Interpolation::linear);
  EXPECT_NEAR(end_of("(parameter a) (* a white)", {{"a", {.value = knock, .where = {}}}}), 0.2, 0.02);
}

TEST(Graphs, GoesOnWhereASoundCanBeExcitedAgain) {
  for (const char* text : {"(sine 440)", "(timer 100 101 white)", "(+ (damp 440 0.002) (timer 19.5 100 white))", "1",
                           "(damp 440 0)", "(less (damp 440 0.01) 0.5)", "(* white (keyframe linear 0 1 1 0.5))",
                           "(sign (damp 440 0.01))", "(keyframe hold 0 0 15 1)"}) {
    EXPECT_EQ(end_of(text), -1.0) << text;
  }
}

}  // namespace idiophone::timbre
