// Tools, strips of a side, and the choice of cuts.

#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "block_mesh.hpp"
#include "idiophone/study/bench/cut_plan.hpp"
#include "nonnegative.hpp"

namespace idiophone::bench {
namespace {

using ::testing::HasSubstr;

std::string refusal_of_tools(const std::vector<std::string>& texts) {
  try {
    static_cast<void>(read_tools(texts));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Tools, AreReadOrRefused) {
  const std::vector<Tool> tools = read_tools({"router:0.006", "sander:0.02"});
  ASSERT_EQ(tools.size(), 2U);
  EXPECT_EQ(depth_share(tools[0], 0.0059), 1.0);
  EXPECT_EQ(depth_share(tools[0], -0.0061), 0.0);
  EXPECT_NEAR(depth_share(tools[1], 0.01), 0.5, 1e-12);
  EXPECT_EQ(depth_share(tools[1], 0.021), 0.0);
  for (const char* text :
       {"router", "router:", "router:-1", "router:0", "router:nan", "router:0.006m", "saw:0.01", ""}) {
    EXPECT_THAT(refusal_of_tools({text}), HasSubstr("is not a tool")) << text;
  }
  EXPECT_THAT(refusal_of_tools({}), HasSubstr("needs a tool"));
}

// Karush, Kuhn and Tucker's conditions make the solution certain.
TEST(NonnegativeLeastSquares, FulfilsTheConditionsOfTheLeast) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(3, 40, [&] { return uniform(random); });
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(3, [&] { return uniform(random); });
    const Eigen::MatrixXd negative = trial % 2 ? a : Eigen::MatrixXd(-a.cwiseAbs());
    const Eigen::VectorXd x = nonnegative_least_squares(negative, b);
    const Eigen::VectorXd gradient = negative.transpose() * (negative * x - b);
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_GE(gradient.minCoeff(), -1e-7);
    EXPECT_NEAR(gradient.dot(x), 0.0, 1e-9);
  }
}

constexpr double length = 0.3, width = 0.05, height = 0.02;  // m

/// A block whose slopes are 1 and x, in cents/m3.
Strips strips_of_block(const std::string& side) {
  const mesh::Mesh mesh = support::block_mesh(element::hex(3, 2), {length, width, height}, {5, 1, 1});
  eigenmodes::RemovalSlopes removal;
  removal.slopes.resize(2);
  for (Index node = 0; node < std::ssize(mesh.nodes); ++node) {
    removal.nodes.push_back(node);
    removal.slopes[0].push_back(1.0);
    removal.slopes[1].push_back(mesh.nodes[node].x());
  }
  return strips_of(mesh, removal, read_side(side, mesh));
}

TEST(Strips, AddUpToTheSide) {
  const Strips below = strips_of_block("");
  EXPECT_NEAR(below.slopes.row(0).sum(), length * width, 1e-12);
  EXPECT_NEAR(below.slopes.row(1).sum(), length * width * length / 2, 1e-12);
  EXPECT_NEAR(slopes_of(below, {"router", Profile::groove, 0.01}, 0.1)[1], 0.02 * width * 0.1, 5e-7);
  EXPECT_NEAR(strips_of_block("-y").slopes.row(0).sum(), length * height, 1e-12);
  EXPECT_THROW(static_cast<void>(strips_of_block("below")), std::runtime_error);
}

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

Plan plan_for(const Eigen::Vector2d& cents, const PlanOptions& options = {}, double uncertainty = 0.5,
              bool are_ratios = false) {
  return plan_cuts(bar(), both_tools, {cents, Eigen::Vector2d::Constant(uncertainty), are_ratios}, options);
}

/// Requires that no partial passes its target by more than a limit, with two standard deviations.
void expect_safe(const Plan& plan, double limit) {
  for (Eigen::Index p = 0; p < plan.errors.size(); ++p) {
    const double passed = plan.errors[p] > 0 ? -plan.expected[p] : plan.expected[p];
    EXPECT_LE(passed + 2 * plan.uncertainties[p], limit + 1e-9) << "partial " << p;
  }
}

TEST(Plan, BringsPartialsNearerAndNotTooFar) {
  const Plan plan = plan_for({60, 30});
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_LE(plan.cuts.size(), 2U);
  EXPECT_LT(plan.expected[0], 30);
  EXPECT_LT(plan.expected[1], 20);
  expect_safe(plan, 3);
  Eigen::Vector2d sum = plan.errors;
  for (const Cut& cut : plan.cuts) {
    sum += cut.cents;
    EXPECT_LE(cut.depth, 1e-3);
    EXPECT_GE(cut.depth, 1e-4);
    EXPECT_LE(cut.cents.cwiseAbs().maxCoeff(), 100);
  }
  EXPECT_NEAR((sum - plan.expected).norm(), 0, 1e-9);
}

TEST(Plan, OfRatiosLeavesThePitchFree) {
  const Plan plan = plan_for({500, 540}, {}, 0.5, true);
  ASSERT_EQ(plan.verdict, Verdict::cut);
  EXPECT_NEAR(plan.errors[0], 0, 1e-12);
  EXPECT_NEAR(plan.errors[1], 40, 1e-12);
  EXPECT_LT(plan.expected[1], 20);
  expect_safe(plan, 3);
}

TEST(Plan, EndsWhereThePartialsAreInTune) {
  const Plan plan = plan_for({2.5, -2.5});
  EXPECT_EQ(plan.verdict, Verdict::in_tune);
  EXPECT_TRUE(plan.cuts.empty());
}

TEST(Plan, SaysWhatIsNotSafe) {
  EXPECT_EQ(plan_for({20, 10}, {.depth_error = 5e-4}).verdict, Verdict::not_safe);
}

TEST(Plan, SaysWhatIsOutOfReach) {
  Strips lowering = bar();
  lowering.slopes = -lowering.slopes.cwiseAbs();
  const Plan plan = plan_cuts(lowering, both_tools, {Eigen::Vector2d(20, -15), Eigen::Vector2d(1, 1), false}, {});
  EXPECT_EQ(plan.verdict, Verdict::out_of_reach);
  EXPECT_LE(plan.unreachable[1], -15);
  EXPECT_TRUE(plan.cuts.empty());
}

}  // namespace
}  // namespace idiophone::bench
