#include "idiophone/instruments/resonators/point_forces.hpp"

#include <algorithm>
#include <span>

#include "idiophone/instruments/resonators/force.hpp"
#include "idiophone/instruments/score/score.hpp"

namespace idiophone::resonators {

namespace {

constexpr double shortest_piece = 0.005;  // m, of a stroke, in which mode shapes are taken to be linear
constexpr std::size_t most_pieces = 64;   // likewise

/// A force that grows from zero at `first` to its full value at `middle` and falls to zero at `last`.
ForceCurve piece_of_stroke(std::span<const double> force, std::size_t first, std::size_t middle, std::size_t last) {
  const auto weighted = [&](std::size_t n) {
    if (n == middle) {
      return force[n];
    }
    const double share = n < middle ? static_cast<double>(n - first) / static_cast<double>(middle - first)
                                    : static_cast<double>(last - n) / static_cast<double>(last - middle);
    return share * force[n];
  };
  ForceCurve pieces;
  for (std::size_t n = first; n < last; ++n) {
    pieces.push_back(linear_piece(weighted(n), weighted(n + 1)));
  }
  return pieces;
}

std::vector<PointForce> forces_of(const score::Stroke& stroke, std::int64_t start, std::uint64_t seed, int rate) {
  const std::vector<double> force = stroke_force(stroke, seed, rate);
  const Vector3 way = stroke.to - stroke.from;
  const Vector3 direction = stroke.direction + stroke.friction * way.normalized();
  const std::size_t last = force.size() - 1;
  const std::size_t count =
      std::clamp<std::size_t>(static_cast<std::size_t>(way.norm() / shortest_piece), 1, std::min(most_pieces, last));
  std::vector<PointForce> forces;
  for (std::size_t i = 0; i <= count; ++i) {
    const std::size_t first = (i == 0 ? 0 : i - 1) * last / count;
    const std::size_t middle = i * last / count;
    const std::size_t end = std::min(i + 1, count) * last / count;
    forces.push_back({.start = start + static_cast<std::int64_t>(first),
                      .at = stroke.from + static_cast<double>(middle) / static_cast<double>(last) * way,
                      .direction = direction,
                      .force = piece_of_stroke(force, first, middle, end)});
  }
  return forces;
}

}  // namespace

std::vector<PointForce> point_forces(const score::ScoreEvent& event, std::int64_t start, std::uint64_t seed, int rate) {
  if (const auto* stroke = std::get_if<score::Stroke>(&event.action)) {
    return forces_of(*stroke, start, seed, rate);
  }
  if (const auto* blow = std::get_if<score::HammerBlow>(&event.action)) {
    const HertzPulse pulse(blow->hammer);
    const auto force = [&](double time) { return pulse.at(time); };
    return {{start, blow->at, blow->direction, sampled(force, pulse.duration, rate)}};
  }
  if (const auto* applied = std::get_if<score::AppliedForce>(&event.action)) {
    const auto force = [&](double time) { return applied->signal.at(time); };
    return {{start, applied->at, applied->force, sampled(force, applied->end(), rate)}};
  }
  return {};
}

}  // namespace idiophone::resonators
