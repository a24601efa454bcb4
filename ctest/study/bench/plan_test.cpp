// Plans of cuts: how near partials come to their targets, and what is refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/study/bench/cut_plan.hpp"

namespace idiophone::bench {
namespace {

/// A bar of 0.3 m whose two partials fall where it bends and rise at its ends.
Strips bar() {
  Strips strips;
  constexpr int count = 600;
  strips.width = 0.3 / count;
  strips.thickness = 0.02;
  strips.slopes.resize(2, count);
  for (int strip = 0; strip < count; ++strip) {
    const double x = (strip + 0.5) / count - 0.5;
    strips.places.push_back(0.3 * x);
    strips.slopes(0, strip) = 2000 * (0.15 - std::pow(std::cos(std::numbers::pi * x), 2));
    strips.slopes(1, strip) = 2000 * (0.15 - std::pow(std::sin(2 * std::numbers::pi * x), 2));
  }
  return strips;
}

const std::vector<Tool> both_tools = {{"router", Profile::groove, 0.006}, {"sander", Profile::hollow, 0.02}};

/// A body whose slopes do not change with its cuts.
CutModel straight(const Strips& strips) {
  return [strips](const std::vector<Cut>& cuts) {
    CutBody body{Eigen::VectorXd::Zero(strips.slopes.rows()), strips};
    for (const Cut& cut : cuts) {
      body.moved += cut.depth * slopes_of(strips, cut.tool, cut.place);
    }
    return body;
  };
}

Plan plan_for(const Eigen::Vector2d& cents, const PlanOptions& options = {}, double uncertainty = 0.5,
              bool are_ratios = false) {
  return plan_cuts(straight(bar()), both_tools, {cents, Eigen::Vector2d::Constant(uncertainty), are_ratios}, options);
}

/// Requires that no partial passes its target by more than a limit, with three standard deviations.
void expect_safe(const Plan& plan, double limit) {
  Eigen::VectorXd from = plan.errors;
  for (const Visit& visit : plan.visits) {
    for (Eigen::Index p = 0; p < from.size(); ++p) {
      const double passed = from[p] > 0 ? -visit.expected[p] : visit.expected[p];
      EXPECT_LE(passed + 3 * visit.uncertainties[p], limit + 1e-9) << "partial " << p;
    }
    from = visit.expected;
  }
}

TEST(Plan, BringsPartialsNearerAndNotTooFar) {
  const Plan plan = plan_for({60, 30});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  const Visit& next = plan.visits.front();
  EXPECT_LT(next.expected[0], 30);
  EXPECT_LT(next.expected[1], 20);
  expect_safe(plan, 5);
  Eigen::Vector2d sum = plan.errors;
  for (const Cut& cut : next.cuts) {
    sum += cut.cents;
    EXPECT_LE(cut.depth, 1e-3);
    EXPECT_GE(cut.depth, 1e-4);
  }
  EXPECT_NEAR((sum - next.expected).norm(), 0, 1e-9);
}

// Narrow grooves on narrow grooves do more than the model says.
TEST(Plan, MakesNoNarrowGrooveDeeper) {
  const std::vector<Tool> narrow = {{"router", Profile::groove, 0.003, 0.15}};
  const Partials partials{Eigen::Vector2d(60, 30), Eigen::Vector2d(0.5, 0.5), false};
  const auto nearest_to = [](const Plan& plan, double place) {
    double nearest = 1.0;
    for (const Cut& cut : plan.visits.front().cuts) {
      nearest = std::min(nearest, std::abs(cut.place - place));
    }
    return nearest;
  };
  const Plan free = plan_cuts(straight(bar()), narrow, partials, {});
  ASSERT_EQ(free.verdict, Verdict::cut);
  const double place = free.visits.front().cuts.front().place;
  const Cut groove{narrow.front(), place, 2e-4, {}};
  const Plan beside = plan_cuts(straight(bar()), narrow, partials, {}, {groove});
  ASSERT_EQ(beside.verdict, Verdict::cut);
  EXPECT_GE(nearest_to(beside, place), 0.006);
  const Cut wide{both_tools.front(), place, 2e-4, {}};
  EXPECT_LT(nearest_to(plan_cuts(straight(bar()), narrow, partials, {}, {wide}), place), 0.006);
  std::vector<Cut> everywhere;
  for (double x = -0.15; x < 0.155; x += 0.005) {
    everywhere.push_back({narrow.front(), x, 2e-4, {}});
  }
  const Plan none = plan_cuts(straight(bar()), narrow, partials, {}, everywhere);
  EXPECT_EQ(none.verdict, Verdict::out_of_reach);
  EXPECT_EQ(none.unreachable, none.errors);
}

TEST(Plan, LooksAheadToTheTarget) {
  const Plan plan = plan_for({60, 30}, {.depth_error = 2e-5});
  ASSERT_GE(plan.visits.size(), 2U);
  EXPECT_LE(plan.visits.size(), 6U);
  EXPECT_LE(plan.visits.back().expected.cwiseAbs().maxCoeff(), 3);
}

// A cut of this body moves its partials by the square of the depth, too.
TEST(Plan, TakesWhatTheModelSolvesInsteadOfSlopes) {
  const CutModel curved = [](const std::vector<Cut>& cuts) {
    CutBody body = straight(bar())(cuts);
    const double more = 1 + 0.02 * body.moved.norm();
    body.moved *= more;
    body.strips.slopes *= 2 * more - 1;
    return body;
  };
  const Plan plan = plan_cuts(curved, both_tools, {Eigen::Vector2d(60, 30), Eigen::Vector2d(0.5, 0.5), false}, {});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  expect_safe(plan, 5);
  std::vector<Cut> made;
  for (const Visit& visit : plan.visits) {
    made.insert(made.end(), visit.cuts.begin(), visit.cuts.end());
    EXPECT_NEAR((plan.errors + curved(made).moved - visit.expected).norm(), 0, 1e-9);
  }
}

TEST(Plan, EndsWhereTheModelEnds) {
  const Plan whole = plan_for({60, 30}, {.depth_error = 2e-5});
  ASSERT_GE(whole.visits.size(), 2U);
  const auto up_to = [](std::size_t most) -> CutModel {
    return [most](const std::vector<Cut>& cuts) {
      if (cuts.size() > most) {
        throw OutsideOfModel("too many cuts");
      }
      return straight(bar())(cuts);
    };
  };
  const Partials partials{Eigen::Vector2d(60, 30), Eigen::Vector2d(0.5, 0.5), false};
  const Plan plan = plan_cuts(up_to(whole.visits.front().cuts.size()), both_tools, partials, {.depth_error = 2e-5});
  EXPECT_EQ(plan.verdict, Verdict::cut);
  EXPECT_EQ(plan.visits.size(), 1U);
  EXPECT_THROW(static_cast<void>(plan_cuts(up_to(0), both_tools, partials, {})), OutsideOfModel);
}

TEST(Plan, OfRatiosLeavesThePitchFree) {
  const Plan plan = plan_for({500, 540}, {}, 0.5, true);
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_NEAR(plan.errors[0], 0, 1e-12);
  EXPECT_NEAR(plan.errors[1], 40, 1e-12);
  EXPECT_LT(plan.visits.front().expected[1], 20);
  expect_safe(plan, 5);
}

TEST(Plan, EndsWhereThePartialsAreInTune) {
  const Plan plan = plan_for({2.5, -2.5});
  EXPECT_EQ(plan.verdict, Verdict::in_tune);
  EXPECT_TRUE(plan.visits.empty());
}

TEST(Plan, AsksForAnotherTapWhereALineThatIsCarriedOverMayBeOutOfTune) {
  const auto plan_with = [](double error, double uncertainty) {
    const Partials partials{Eigen::Vector2d(error, -error), Eigen::Vector2d(0.5, uncertainty), false, {false, true}};
    return plan_cuts(straight(bar()), both_tools, partials, {});
  };
  EXPECT_EQ(plan_with(2.5, 1.0).verdict, Verdict::in_tune);
  for (const double error : {2.5, 2.95}) {  // cuts that lower both could bring one nearer, and the other out of tune
    const Plan plan = plan_with(error, 4.0);
    EXPECT_EQ(plan.verdict, Verdict::not_safe);
    EXPECT_FALSE(plan.is_measured);
  }
}

// At all places that lower the first partial, twice the error of the depth throws it by more than a quarter of its
// error.
TEST(Plan, TakesRoughCutsWhereNoGentleOnesAreSafe) {
  const Plan plan = plan_for({20, 1}, {.deepest = 5e-4});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_LT(plan.visits.front().expected[0], 12);
  expect_safe(plan, 5);
}

TEST(Plan, SaysWhatIsNotSafe) {
  EXPECT_EQ(plan_for({20, 10}, {.depth_error = 5e-4}).verdict, Verdict::not_safe);
}

TEST(Plan, MakesCutsOfDoubtedToolsShallower) {
  std::vector<Tool> doubted = both_tools;
  for (Tool& tool : doubted) {
    tool.slope_error = 0.25;
  }
  const Partials partials{Eigen::Vector2d(60, 30), Eigen::Vector2d(0.5, 0.5), false};
  const Plan plan = plan_cuts(straight(bar()), doubted, partials, {});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_GT(plan.visits.front().expected.norm(), plan_for({60, 30}).visits.front().expected.norm());
}

/// A body that jumps too far at a cut that is deeper than `harmless` (m), whatever the slopes say.
CutModel jumping(double harmless) {
  return [harmless](const std::vector<Cut>& cuts) {
    CutBody body = straight(bar())(cuts);
    const bool jumps = std::ranges::any_of(cuts, [&](const Cut& cut) { return cut.depth > harmless; });
    body.moved.array() -= jumps ? 500 : 0;
    return body;
  };
}

TEST(Plan, MakesCutsShallowerOrRefusesThemWhereTheSolvedBodyGoesTooFar) {
  const Partials partials{Eigen::Vector2d(60, 30), Eigen::Vector2d(0.5, 0.5), false};
  const Plan never = plan_cuts(jumping(0), both_tools, partials, {});
  EXPECT_EQ(never.verdict, Verdict::not_safe);
  EXPECT_FALSE(never.is_settled);
  const Plan shallow = plan_cuts(jumping(4e-4), both_tools, partials, {});
  EXPECT_EQ(shallow.verdict, Verdict::cut);
  expect_safe(shallow, 5);
  const Plan careful = plan_for({20, 10}, {.depth_error = 5e-4});
  EXPECT_TRUE(careful.is_settled);
}

// As beside grooves that a coarse mesh bears badly: whatever the slopes say, cuts of one half do nothing.
TEST(Plan, TriesOtherPlacesWhereTheSolvedBodyDoesNotDoWhatTheSlopesSay) {
  const CutModel half_dead = [](const std::vector<Cut>& cuts) {
    std::vector<Cut> alive = cuts;
    std::erase_if(alive, [](const Cut& cut) { return cut.place < 0; });
    return straight(bar())(alive);
  };
  const Partials partials{Eigen::Vector2d(60, 15), Eigen::Vector2d(0.5, 0.5), false};
  const Plan plan = plan_cuts(half_dead, both_tools, partials, {});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_LT(plan.visits.front().expected.norm(), 30);
  EXPECT_GE(plan.visits.front().cuts.front().place, 0);
  expect_safe(plan, 5);
}

TEST(Plan, KeepsASafeVisitWhereOtherPlacesLeaveTheModel) {
  const CutModel half_known = [](const std::vector<Cut>& cuts) {
    std::vector<Cut> weak = cuts;
    for (Cut& cut : weak) {
      if (cut.place >= 0) {
        throw OutsideOfModel("a place that is not known");
      }
      cut.depth *= 0.05;
    }
    return straight(bar())(weak);
  };
  const Partials partials{Eigen::Vector2d(60, 15), Eigen::Vector2d(0.5, 0.5), false};
  const Plan plan = plan_cuts(half_known, both_tools, partials, {});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_LT(plan.visits.front().cuts.front().place, 0);
}

// No cut by the doubted tool is allowed, so it is the solved body that refuses the cuts.
TEST(Plan, RemembersThatTheSolvedBodyRefusedCutsOfTheFirstTools) {
  std::vector<Tool> tools = both_tools;
  tools[0].slope_error = 50.0;
  const Partials partials{Eigen::Vector2d(60, 30), Eigen::Vector2d(0.5, 0.5), false};
  const Plan plan = plan_cuts(jumping(0), tools, partials, {.depth_error = 5e-5});
  EXPECT_EQ(plan.verdict, Verdict::not_safe);
  EXPECT_FALSE(plan.is_settled);
}

TEST(Plan, SaysWhatIsOutOfReach) {
  Strips lowering = bar();
  lowering.slopes = -lowering.slopes.cwiseAbs();
  const Plan plan =
      plan_cuts(straight(lowering), both_tools, {Eigen::Vector2d(20, -15), Eigen::Vector2d(1, 1), false}, {});
  EXPECT_EQ(plan.verdict, Verdict::out_of_reach);
  EXPECT_LE(plan.unreachable[1], -15);
  EXPECT_TRUE(plan.visits.empty());
}

}  // namespace
}  // namespace idiophone::bench
