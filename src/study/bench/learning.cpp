#include "idiophone/study/bench/learning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "doubt.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "tap_expectation.hpp"
#include "tap_hypotheses.hpp"

namespace idiophone::bench {

namespace {

constexpr double certain = 0.99;
constexpr double surprising = 3.0;  // standard deviations

Estimate estimate_of(const TapHypothesis& hypothesis, Eigen::Index unknown, std::string name) {
  return {std::move(name), hypothesis.unknowns[unknown],
          std::sqrt(std::max(0.0, hypothesis.covariance(unknown, unknown)))};
}

/// Carries over the lines of earlier taps that the last one certainly misses.
void carry_over(Learned& learned, const TapHypothesis& hypothesis, const std::vector<std::size_t>& tuned,
                const ExpectedTap& last) {
  learned.carried.resize(tuned.size());
  for (std::size_t p = 0; p < tuned.size(); ++p) {
    const std::optional<HeardLine>& heard = hypothesis.heard[tuned[p]];
    if (heard && !learned.lines[p] && !learned.is_doubted[p]) {
      const Pitch pitch = hypothesis.pitch_of(tuned[p], last);
      const double frequency = std::exp2(pitch.cents / 1200);
      learned.lines[p] = {.frequency = frequency, .uncertainty = pitch.deviation};
      learned.carried[p] = {heard->tap, partials::cents(frequency, heard->frequency)};
    }
  }
}

/// Doubts the line that is farthest from where its mode was expected, if that is far: a cut was not made as asked, or
/// the tap is wrong. The next tap decides.
void doubt_surprise(Learned& learned, const TapHypothesis& hypothesis, const std::vector<std::size_t>& tuned,
                    const std::vector<fitting::Line>& lines) {
  const std::size_t mode =
      *std::ranges::max_element(tuned, {}, [&](std::size_t each) { return std::abs(hypothesis.surprises[each]); });
  if (!learned.doubt && std::abs(hypothesis.surprises[mode]) > surprising) {
    learned.doubt = {.mode = mode,
                     .line = lines[*hypothesis.lines[mode]].frequency,
                     .other_line = {},
                     .other = {},
                     .surprise = hypothesis.surprises[mode]};
  }
}

/// Takes the constants that the taps tell. They are estimates by slopes, which know no bounds, so they go only as far
/// as the material stays stable.
void learn_constants(Learned& learned, const scene::Material& material, const TapHypothesis& hypothesis,
                     const TapUnknowns& unknowns) {
  if (unknowns.constants.empty()) {
    return;
  }
  const Eigen::VectorXd moves =
      fitting::stable_part(material, hypothesis.unknowns.segment(unknowns.constant(0), std::ssize(unknowns.constants)));
  for (std::size_t c = 0; c < unknowns.constants.size(); ++c) {
    learned.constants.push_back(estimate_of(hypothesis, unknowns.constant(c), unknowns.constants[c]));
    learned.constants.back().expected = moves[static_cast<Eigen::Index>(c)];
  }
  learned.material = fitting::moved(material, moves);
}

/// The cuts with the depths that they have.
std::vector<Cut> real_cuts(const std::vector<Cut>& made, const std::vector<Estimate>& depths, double thinner,
                           const Strips& strips) {
  const double length = strips.high() - strips.low();
  const double middle = (strips.high() + strips.low()) / 2;
  std::vector<Cut> cuts = {{{"thickness", Profile::groove, length}, middle, thinner, {}}};
  for (std::size_t c = 0; c < made.size(); ++c) {
    cuts.push_back({made[c].tool, made[c].place, std::max(0.0, made[c].depth + depths[c].expected), {}});
  }
  return cuts;
}

}  // namespace

Learned learn(const Workpiece& piece, const std::vector<Cut>& made, const std::vector<Tap>& taps,
              const Beliefs& beliefs) {
  TapExpectations expectations(piece, made, beliefs);
  TapHypotheses hypotheses(expectations.unknowns().size());
  ExpectedTap last;
  for (const Tap& tap : taps) {
    last = expectations.of(tap);
    hypotheses.hear(tap.lines, last);
  }
  const std::vector<fitting::Line>& lines = taps.back().lines;
  const std::vector<std::size_t>& tuned = piece.uncut().tuned;
  const TapHypothesis& best = hypotheses.all().front();
  const Certainness certainness = certainness_of(hypotheses, tuned, lines);
  const TapUnknowns& unknowns = expectations.unknowns();
  Learned learned;
  learned.probability = certainness.probability;
  for (const std::size_t mode : tuned) {
    learned.computed.push_back(std::exp2(last.cents[static_cast<Eigen::Index>(mode)] / 1200));
    learned.lines.push_back(best.lines[mode] ? std::optional(lines[*best.lines[mode]]) : std::nullopt);
  }
  if (certainness.probability < certain && certainness.rival != nullptr) {
    learned.doubt = doubt_between(best, *certainness.rival, certainness.mode, lines);
  }
  for (const std::size_t mode : tuned) {
    const bool is_named = learned.doubt && learned.doubt->mode == mode;
    const std::array<std::size_t, 1> alone = {mode};
    learned.is_doubted.push_back(is_named || certainness_of(hypotheses, alone, lines).probability < certain);
  }
  doubt_surprise(learned, best, tuned, lines);
  carry_over(learned, best, tuned, last);
  learn_constants(learned, piece.material(), best, unknowns);
  for (std::size_t c = 0; c < made.size(); ++c) {
    learned.depths.push_back(estimate_of(best, unknowns.depth(c), {}));
  }
  learned.cuts = real_cuts(made, learned.depths, best.unknowns[TapUnknowns::thickness], expectations.strips());
  return learned;
}

}  // namespace idiophone::bench
