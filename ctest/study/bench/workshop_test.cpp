// A workshop of bars of random wood, which the plans of cuts tune to 1 : 4 : 10. The bars are beams, so that a test can
// tune a hundred of them; tools/tuning_workshop tunes finite elements.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "beam.hpp"
#include "idiophone/study/bench/cut_plan.hpp"

namespace idiophone::bench {
namespace {

const Eigen::Vector3d targets(0.0, 1200 * std::log2(4.0), 1200 * std::log2(10.0));

class Workshop {
 public:
  explicit Workshop(unsigned seed) : random_(seed) {
    real_.young *= std::exp(normal(0.10));
    real_.shear *= std::exp(normal(0.15));
    real_.density *= std::exp(normal(0.05));
    real_.thicker = normal(1e-4);
    real_.relief = std::exp(normal(0.05));
  }

  void tune(const std::vector<Tool>& tools) {
    constexpr int most_visits = 20;
    for (visits = 0; visits < most_visits; ++visits) {
      const Eigen::Vector3d true_cents = real_.with(made_).moved - targets;
      note(true_cents.array() - true_cents[0]);
      Eigen::Vector3d taps = true_cents;
      for (double& tap : taps) {
        tap += normal(0.5);
      }
      const Plan plan = plan_cuts(model(), tools, {taps, Eigen::Vector3d::Constant(0.5), true}, {});
      verdict = plan.verdict;
      if (verdict != Verdict::cut) {
        return;
      }
      for (const Cut& cut : plan.visits.front().cuts) {
        asked_.push_back(cut);
        made_.push_back(cut);
        made_.back().depth = std::max(0.0, cut.depth + normal(1e-4));
      }
    }
  }

  int visits = 0;
  Verdict verdict = Verdict::cut;
  double passed = 0.0;  ///< cents, the farthest way of an interval beyond its target

 private:
  double normal(double deviation) { return std::normal_distribution<double>(0, deviation)(random_); }

  [[nodiscard]] CutModel model() const {
    const Beam nominal;
    const Eigen::VectorXd here = nominal.with(asked_).moved;
    return [this, nominal, here](const std::vector<Cut>& more) {
      std::vector<Cut> all = asked_;
      all.insert(all.end(), more.begin(), more.end());
      CutBody body = nominal.with(all);
      body.moved -= here;
      return body;
    };
  }

  void note(const Eigen::Vector3d& errors) {
    first_ = visits == 0 ? errors : first_;
    for (int p = 1; p < 3; ++p) {
      passed = std::max(passed, first_[p] > 0 ? -errors[p] : errors[p]);
    }
  }

  std::mt19937 random_;
  Beam real_;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();
  std::vector<Cut> asked_, made_;
};

TEST(WorkshopOfBeams, TunesMostBarsWithinFewVisits) {
  const std::vector<Tool> tools = {{"router", Profile::groove, 0.003}, {"sander", Profile::hollow, 0.02}};
  constexpr int bars = 40;
  std::vector<int> visits;
  int in_tune = 0;
  for (unsigned seed = 0; seed < bars; ++seed) {
    Workshop workshop(seed);
    workshop.tune(tools);
    in_tune += workshop.verdict == Verdict::in_tune ? 1 : 0;
    visits.push_back(workshop.visits);
    EXPECT_LT(workshop.passed, 5.0) << "bar " << seed;
  }
  std::ranges::sort(visits);
  EXPECT_GE(in_tune, bars * 9 / 10);
  EXPECT_LE(visits[bars / 2], 3);
  EXPECT_LE(visits.back(), 6);
}

}  // namespace
}  // namespace idiophone::bench
