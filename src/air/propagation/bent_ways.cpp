#include "idiophone/air/propagation/bent_ways.hpp"

#include <algorithm>
#include <optional>

#include "idiophone/air/receivers/edge_filters.hpp"

namespace idiophone::propagation {

namespace {

/// A place beside an edge, for rays that pass it.
Vector3 beside(const radiation::DiffractingEdge& edge, const Vector3& apex) {
  constexpr double gap = 1e-4;  // of the edge's length
  return apex + gap * (edge.end - edge.begin).norm() * edge.outward();
}

}  // namespace

BentWays::BentWays(Options options, std::size_t ways, std::size_t receivers, std::size_t triangles)
    : options_(options), ways_(ways), next_(receivers * ways, std::vector<BentWay>(triangles)) {
  start();
}

void BentWays::find(const DiffractingEdges& edges, const FoldedSight& sight, std::span<const Index> triangles,
                    std::span<const Vector3> receivers) {
  for (std::size_t w = 0; w < ways_; ++w) {
    const auto pair = edges.is_pair(w) ? std::optional(edges.pair(w)) : std::nullopt;
    for (std::size_t r = 0; r < receivers.size(); ++r) {
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        BentWay& way = next_[r * ways_ + w][i];
        if (edges.is_own(w, triangles[i])) {
          way = {};
        } else if (pair) {
          way = around_pair(*pair, sight, triangles[i], receivers[r], edges.is_mirrored(w));
        } else {
          way = around_edge(edges.edge(w), sight, triangles[i], receivers[r], edges.is_mirrored(w));
        }
      }
    }
  }
}

BentWay BentWays::around_edge(const radiation::DiffractingEdge& edge, const FoldedSight& sight, Index triangle,
                              const Vector3& receiver, bool mirrored) const {
  const radiation::Bend bend =
      radiation::find_bend(edge, sight.visibility().centre(triangle), receiver, options_.speed);
  const Vector3 place = beside(edge, bend.apex);
  if (!bend.exists || !sight.is_in_air(place, mirrored) || !sight.sees(triangle, place) ||
      !sight.is_clear(place, receiver)) {
    return {};
  }
  return {.apexes = {bend.apex, bend.apex},
          .gains = {bend.direct.gain, bend.mirrored.gain},
          .numbers = {number_of(bend.direct.delay), number_of(bend.mirrored.delay)}};
}

BentWay BentWays::around_pair(const std::array<radiation::DiffractingEdge, 2>& pair, const FoldedSight& sight,
                              Index triangle, const Vector3& receiver, bool mirrored) const {
  const radiation::DoubleBend bend =
      radiation::find_double_bend(pair[0], pair[1], sight.visibility().centre(triangle), receiver, options_.speed);
  const Vector3 first = beside(pair[0], bend.apexes[0]), last = beside(pair[1], bend.apexes[1]);
  if (!bend.exists || !sight.is_in_air(first, mirrored) || !sight.is_in_air(last, mirrored) ||
      !sight.sees(triangle, first) || !sight.is_clear(first, last) || !sight.is_clear(last, receiver)) {
    return {};
  }
  return {.apexes = bend.apexes,
          .gains = {bend.gain, 0.0},
          .numbers = {number_of(bend.delays[0]), number_of(bend.delays[1])}};
}

double BentWays::number_of(double delay) const {
  return receivers::EdgeFilters::number_of(delay * options_.rate);
}

void BentWays::start() {
  from_ = to_ = next_;
  note_heard();
}

void BentWays::advance() {
  from_.swap(to_);
  to_ = next_;
  note_heard();
}

void BentWays::note_heard() {
  const auto any = [](const std::vector<BentWay>& ways) {
    return !std::ranges::all_of(ways, [](const BentWay& way) { return way.is_silent(); });
  };
  heard_.resize(from_.size());
  for (std::size_t k = 0; k < from_.size(); ++k) {
    heard_[k] = any(from_[k]) || any(to_[k]);
  }
}

BentWay BentWays::at(double weight, std::size_t receiver, std::size_t way, std::size_t triangle) const {
  const BentWay& from = from_[receiver * ways_ + way][triangle];
  const BentWay& to = to_[receiver * ways_ + way][triangle];
  BentWay now = from.is_silent() ? to : from;
  const bool moves = !from.is_silent() && !to.is_silent();
  for (std::size_t k = 0; k < 2; ++k) {
    now.gains.at(k) = from.gains.at(k) + weight * (to.gains.at(k) - from.gains.at(k));
    if (moves) {
      now.apexes.at(k) += weight * (to.apexes.at(k) - from.apexes.at(k));
      now.numbers.at(k) += weight * (to.numbers.at(k) - from.numbers.at(k));
    }
  }
  return now;
}

void BentWays::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  for (Ways* ways : {&from_, &to_, &next_}) {
    for (std::size_t k = 0; k < ways->size(); ++k) {
      auto& [apexes, gains, numbers] = (*ways)[k][triangle];
      for (Vector3& apex : apexes) {
        for (double& coordinate : apex) {
          row.value(coordinate);
        }
      }
      row.values(gains);
      row.values(numbers);
      if (gains != std::array<double, 2>()) {  // it may have been restored
        heard_[k] = true;
      }
    }
  }
}

}  // namespace idiophone::propagation
