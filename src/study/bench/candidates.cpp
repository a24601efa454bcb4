#include "candidates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "idiophone/study/bench/cut_plan.hpp"

namespace idiophone::bench {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Whether a cut by a doubted tool at a place takes material from a groove of another one.
bool deepens_doubted_groove(const Tool& tool, double place, const std::vector<Cut>& made) {
  return tool.slope_error > 0 && std::ranges::any_of(made, [&](const Cut& cut) {
           return cut.tool.profile == Profile::groove && cut.tool.slope_error > 0 &&
                  std::abs(cut.place - place) < cut.tool.radius + tool.radius;
         });
}

}  // namespace

Candidates::Candidates(const Strips& strips, const std::vector<Tool>& tools, const std::vector<Cut>& made) {
  constexpr int strides_of_radius = 4;
  for (const Tool& tool : tools) {
    const double stride = tool.radius / strides_of_radius;
    for (double place = strips.low() + tool.radius; place <= strips.high() - tool.radius + 1e-9; place += stride) {
      if (!deepens_doubted_groove(tool, place, made)) {
        candidates_.push_back({tool, place});
      }
    }
  }
}

MatrixXd Candidates::slopes(const Strips& strips) const {
  MatrixXd slopes(strips.slopes.rows(), std::ssize(candidates_));
  for (Index c = 0; c < slopes.cols(); ++c) {
    const Candidate& candidate = candidates_[static_cast<std::size_t>(c)];
    slopes.col(c) = slopes_of(strips, candidate.tool, candidate.place);
  }
  return slopes;
}

bool Candidates::is_doubted(Index candidate) const {
  return candidates_[static_cast<std::size_t>(candidate)].tool.slope_error > 0;
}

bool Candidates::overlap(Index one, Index other) const {
  const Candidate& a = candidates_[static_cast<std::size_t>(one)];
  const Candidate& b = candidates_[static_cast<std::size_t>(other)];
  return std::abs(a.place - b.place) < a.tool.radius + b.tool.radius;
}

std::vector<Cut> Candidates::cuts(const MatrixXd& slopes, const VectorXd& depths, double shallowest) const {
  std::vector<Cut> cuts;
  for (Index c = 0; c < depths.size(); ++c) {
    if (depths[c] > 0 && depths[c] >= shallowest) {
      const Candidate& candidate = candidates_[static_cast<std::size_t>(c)];
      cuts.push_back({candidate.tool, candidate.place, depths[c], depths[c] * slopes.col(c)});
    }
  }
  std::ranges::sort(cuts, {}, &Cut::place);
  return cuts;
}

Index Candidates::number_of(const Cut& cut) const {
  return std::ranges::find_if(candidates_,
                              [&](const Candidate& candidate) {
                                return candidate.place == cut.place && candidate.tool.name == cut.tool.name &&
                                       candidate.tool.radius == cut.tool.radius;
                              }) -
         candidates_.begin();
}

MatrixXd Candidates::only(const std::vector<Cut>& cuts, const MatrixXd& moves) const {
  MatrixXd kept = MatrixXd::Zero(moves.rows(), moves.cols());
  for (const Cut& cut : cuts) {
    kept.col(number_of(cut)) = moves.col(number_of(cut));
  }
  return kept;
}

MatrixXd Candidates::without(const std::vector<Cut>& cuts, MatrixXd moves) const {
  for (const Cut& cut : cuts) {
    const Index number = number_of(cut);
    for (Index c = 0; c < moves.cols(); ++c) {
      if (overlap(number, c)) {
        moves.col(c).setZero();
      }
    }
  }
  return moves;
}

VectorXd sum_of(const std::vector<Cut>& cuts, Index partials) {
  VectorXd sum = VectorXd::Zero(partials);
  for (const Cut& cut : cuts) {
    sum += cut.cents;
  }
  return sum;
}

}  // namespace idiophone::bench
