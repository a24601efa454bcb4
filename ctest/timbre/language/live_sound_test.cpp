#include "idiophone/timbre/language/live_sound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/timbre/language/tree_builder.hpp"
#include "ranks.hpp"
#include "sounding.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

namespace {

std::vector<double> rendered(LiveSound& sound, std::size_t count) {
  std::vector<double> samples(count);
  sound.render(samples);
  return samples;
}

/// What a call is refused with; empty if it is not.
template <class Work>
std::string refusal_of(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(LiveSounds, AreThoseOfAGraphAsLongAsNothingIsSet) {
  const std::string text = "(parameter f 300) (* (sine f) (pink) (combine (rvector 3 0 1)))";
  LiveSound sound(parse_tree(text, "t.tt"), {.live = {{"f", 300.0}}});
  std::vector<double> samples = rendered(sound, 100);
  std::ranges::copy(rendered(sound, 900), std::back_inserter(samples));
  const auto curve = std::make_shared<const Curve>(std::vector{0.0}, std::vector{300.0}, Interpolation::hold);
  EXPECT_EQ(samples, sound_of(text, 1000, {{"f", {.value = curve, .where = {}}}}));
}

TEST(LiveSounds, FollowTheirParametersWithoutJumps) {
  constexpr int rate = 10000;
  constexpr double smoothing = 0.05;
  LiveSound sound(parse_tree("(parameter level) level", "t.tt"),
                  {.rate = rate, .smoothing = smoothing, .live = {{"level", 2.0}}});
  EXPECT_EQ(rendered(sound, 10), std::vector<double>(10, 2.0));
  sound.set("level", 3.0);
  std::vector<double> change = rendered(sound, 1000);
  change.insert(change.begin(), {2.0, 2.0});
  const double time_constant = smoothing / 6.6384;  // two filters: 1 - (1 + t) exp(-t)
  for (std::size_t n = 0; n + 2 < change.size(); ++n) {
    const double t = static_cast<double>(n) / rate / time_constant;
    EXPECT_NEAR(change[n + 2], 3.0 - (1.0 + t) * std::exp(-t), 0.012) << n;
  }
  EXPECT_NEAR(change[2 + static_cast<std::size_t>(smoothing * rate)], 2.99, 0.0005);
  EXPECT_TRUE(std::ranges::is_sorted(change));  // no overshoot
  for (std::size_t n = 2; n < change.size(); ++n) {
    EXPECT_LT(std::abs(change[n] - 2.0 * change[n - 1] + change[n - 2]), 2e-4) << n;  // nor does the slope jump
  }
}

TEST(LiveSounds, ChangeAtOnceWithoutSmoothing) {
  LiveSound sound(parse_tree("(parameter level 0) level", "t.tt"), {.smoothing = 0.0, .live = {{"level", 0.0}}});
  EXPECT_EQ(rendered(sound, 1).front(), 0.0);
  sound.set("level", -5.0);
  EXPECT_EQ(rendered(sound, 1).front(), -5.0);
}

TEST(LiveSounds, SayHowLongTheyAreSilent) {
  LiveSound sound(parse_tree("(parameter level 1) level", "t.tt"),
                  {.rate = 1000, .smoothing = 0.0, .live = {{"level", 1.0}}});
  rendered(sound, 100);
  EXPECT_EQ(sound.silent_for(), 0.0);
  sound.set("level", 0.0);
  rendered(sound, 500);
  EXPECT_EQ(sound.silent_for(), 0.5);
}

TEST(LiveSounds, RefuseWhatIsWrong) {
  const Tree tree =
      parse_tree("(parameter count 3) (parameter level 1) (* level (combine (rvector count 1 2)))", "t.tt");
  EXPECT_EQ(refusal_of([&] {
              LiveSound(tree, {.live = {{"count", 3.0}}});
            }),
            "t.tt:1:68: length of (rvector ...) is a number that does not change with time, found a signal");
  LiveSound sound(tree, {.live = {{"level", 1.0}}, .constants = {{"count", 5.0}}});
  EXPECT_EQ(refusal_of([&] { sound.set("levle", 1.0); }),
            "LiveSound: 'levle' is not among the live parameters (did you mean 'level'?)");
  EXPECT_EQ(refusal_of([&] { sound.set("count", 1.0); }), "LiveSound: 'count' is not among the live parameters");
  EXPECT_EQ(refusal_of([&] { sound.set("level", NAN); }), "LiveSound: 'level' must be finite");
  EXPECT_THAT(refusal_of([&] {
                LiveSound(tree, {.constants = {{"no", 1.0}}});
              }),
              testing::HasSubstr("has no parameter 'no'"));
  EXPECT_EQ(refusal_of([&] {
              LiveSound(tree, {.live = {{"level", 1.0}}, .constants = {{"level", 1.0}}});
            }),
            "LiveSound: 'level' is both live and constant");
  EXPECT_EQ(refusal_of([&] { LiveSound(tree, {.rate = 0}); }), "LiveSound: the rate must be positive");
}

TEST(TreeBuilders, MakeTheSameTreeAsAText) {
  TreeBuilder builder("hinge");
  const Expression speed = builder.parameter("speed"), pitch = builder.parameter("pitch", 500.0);
  const Expression rasp = builder.define("rasp", 1 + 0.03 * node("perlin", 90));
  const Tree tree = builder.finish(-speed / 2 * node("sine", rasp * (pitch - 1.5)) + node("timer", 0, 1, 2));
  EXPECT_EQ(to_text(tree),
            "(parameter speed)\n(parameter pitch 500)\n(define rasp (+ 1 (* 0.03 (perlin 90))))\n"
            "(+ (* (/ (- speed) 2) (sine (* rasp (- pitch 1.5)))) (timer 0 1 2))\n");
  EXPECT_EQ(to_text(node("sample", text("coin.wav"), word("linear"))), "(sample \"coin.wav\" linear)");
}

TEST(TreeBuilders, RefuseWhatATextCouldNotSay) {
  TreeBuilder builder("twice");
  builder.parameter("a");
  builder.parameter("a");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(builder.finish(1.0)); }), "twice:2:12: the name 'a' is there already");
}

}  // namespace idiophone::timbre
