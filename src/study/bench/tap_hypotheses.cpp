#include "tap_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "idiophone/study/partials/compare.hpp"

namespace idiophone::bench {

namespace {

using Eigen::VectorXd;
using fitting::Line;

constexpr std::size_t most_hypotheses = 200;
constexpr double false_lines = 1e-3;  // for each cent
constexpr double farthest = 6.0;      // standard deviations of a line from its mode

/// A hypothesis with one mode more.
struct Extension {
  std::size_t parent = 0;
  std::optional<std::size_t> line;
  double off = 0.0;     ///< cents of the line above its mode
  double square = 0.0;  ///< of their standard deviation
  double likelihood = 0.0;
};

/// All that is asked of a mode of a tap.
struct ExpectedMode {
  double cents;
  Eigen::RowVectorXd slopes;
  double heard;
};

double cents_of(const Line& line) {
  return partials::cents(line.frequency, 1.0);
}

/// Adds the ways to go on with a mode.
void extend(const TapHypothesis& known, std::size_t parent, const ExpectedMode& mode, std::span<const Line> lines,
            std::vector<Extension>& extensions) {
  const double middle = mode.cents + mode.slopes.dot(known.unknowns);
  const double spread = mode.slopes * known.covariance * mode.slopes.transpose();
  const bool is_among = middle > cents_of(lines.front()) && middle < cents_of(lines.back());
  extensions.push_back({parent, {}, 0.0, 0.0, known.likelihood + (is_among ? std::log(1 - mode.heard) : 0.0)});
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const double off = cents_of(lines[l]) - middle;
    const double square = spread + std::pow(lines[l].uncertainty, 2);
    if (off * off > farthest * farthest * square || std::ranges::find(known.lines, l) != known.lines.end()) {
      continue;
    }
    const double density = -0.5 * (off * off / square + std::log(2 * std::numbers::pi * square));
    extensions.push_back({parent, l, off, square, known.likelihood + std::log(mode.heard / false_lines) + density});
  }
}

/// The hypothesis after an extension, by Kalman's gain.
TapHypothesis extended(TapHypothesis known, const Extension& extension, const ExpectedMode& mode) {
  known.likelihood = extension.likelihood;
  known.lines.push_back(extension.line);
  known.surprises.push_back(extension.line ? extension.off / std::sqrt(extension.square) : 0.0);
  if (extension.line) {
    const VectorXd way = known.covariance * mode.slopes.transpose();
    known.unknowns += way * (extension.off / extension.square);
    known.covariance -= way * way.transpose() / extension.square;
  }
  return known;
}

}  // namespace

Pitch TapHypothesis::pitch_of(std::size_t mode, const ExpectedTap& expected) const {
  const auto row = static_cast<Eigen::Index>(mode);
  const Eigen::RowVectorXd slopes = expected.slopes.row(row);
  return {expected.cents[row] + slopes.dot(unknowns),
          std::sqrt(std::max(0.0, slopes.dot(covariance * slopes.transpose())))};
}

TapHypotheses::TapHypotheses(Eigen::Index unknowns)
    : hypotheses_{{VectorXd::Zero(unknowns), Eigen::MatrixXd::Zero(unknowns, unknowns), 0.0, {}}} {}

void TapHypotheses::hear(std::span<const Line> lines, const ExpectedTap& expected) {
  for (TapHypothesis& hypothesis : hypotheses_) {
    hypothesis.covariance.diagonal() += expected.spread.cwiseAbs2();
    hypothesis.lines.clear();
    hypothesis.surprises.clear();
    hypothesis.heard.resize(static_cast<std::size_t>(expected.cents.size()));
  }
  for (Eigen::Index m = 0; m < expected.cents.size(); ++m) {
    const ExpectedMode mode{expected.cents[m], expected.slopes.row(m), expected.heard[static_cast<std::size_t>(m)]};
    std::vector<Extension> extensions;
    for (std::size_t parent = 0; parent < hypotheses_.size(); ++parent) {
      extend(hypotheses_[parent], parent, mode, lines, extensions);
    }
    std::ranges::stable_sort(extensions, std::ranges::greater(), &Extension::likelihood);
    extensions.resize(std::min(extensions.size(), most_hypotheses));
    std::vector<TapHypothesis> next;
    for (const Extension& extension : extensions) {
      next.push_back(extended(hypotheses_[extension.parent], extension, mode));
      if (extension.line) {
        next.back().heard[static_cast<std::size_t>(m)] = {taps_, lines[*extension.line].frequency};
      }
    }
    hypotheses_ = std::move(next);
  }
  ++taps_;
}

Certainness certainness_of(const TapHypotheses& hypotheses, std::span<const std::size_t> modes,
                           std::span<const Line> lines) {
  const std::vector<TapHypothesis>& all = hypotheses.all();
  const auto contradicts = [&](const TapHypothesis& other, std::size_t mode) {
    const auto line = all.front().lines[mode], other_line = other.lines[mode];
    if (!line || !other_line) {
      const auto free = line ? line : other_line;
      const TapHypothesis& without = line ? other : all.front();
      return free && std::ranges::find(without.lines, *free) != without.lines.end();
    }
    const double apart = std::abs(partials::cents(lines[*line].frequency, lines[*other_line].frequency));
    return apart > std::min(lines[*line].uncertainty, lines[*other_line].uncertainty);
  };
  Certainness result;
  double like = 0.0, sum = 0.0;
  for (const TapHypothesis& hypothesis : all) {
    const double weight = std::exp(hypothesis.likelihood - all.front().likelihood);
    sum += weight;
    const auto mode = std::ranges::find_if(modes, [&](std::size_t m) { return contradicts(hypothesis, m); });
    if (mode == modes.end()) {
      like += weight;
    } else if (result.rival == nullptr) {
      result.rival = &hypothesis;
      result.mode = *mode;
    }
  }
  result.probability = like / sum;
  return result;
}

}  // namespace idiophone::bench
