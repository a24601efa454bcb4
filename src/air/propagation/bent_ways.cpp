#include "idiophone/air/propagation/bent_ways.hpp"

#include <algorithm>
#include <utility>

#include "idiophone/air/receivers/edge_filters.hpp"

namespace idiophone::propagation {

BentWays::BentWays(Options options, std::size_t receivers, std::size_t triangles)
    : options_(std::move(options)), next_(receivers * edges(), std::vector<BentWay>(triangles)) {
  start();
}

void BentWays::find(const radiation::Visibility& visibility, std::span<const Index> triangles,
                    std::span<const Vector3> receivers) {
  constexpr double gap = 1e-4;  // from the edge to the rays that pass it, of its length
  for (std::size_t r = 0; r < receivers.size(); ++r) {
    for (std::size_t e = 0; e < edges(); ++e) {
      const radiation::ScreenEdge& edge = options_.edges[e];
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        BentWay& way = next_[r * edges() + e][i] = BentWay();
        const radiation::Bend bend =
            radiation::find_bend(edge, visibility.centre(triangles[i]), receivers[r], options_.speed);
        const Vector3 beside = bend.apex + gap * (edge.end - edge.begin).norm() * edge.outward;
        if (bend.exists && visibility.sees(triangles[i], beside) && visibility.is_clear(beside, receivers[r])) {
          way.apex = bend.apex;
          way.gains = {bend.direct.gain, bend.mirrored.gain};
          way.numbers = {receivers::EdgeFilters::number_of(bend.direct.delay * options_.rate),
                         receivers::EdgeFilters::number_of(bend.mirrored.delay * options_.rate)};
        }
      }
    }
  }
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

BentWay BentWays::at(double weight, std::size_t receiver, std::size_t edge, std::size_t triangle) const {
  const BentWay& from = from_[receiver * edges() + edge][triangle];
  const BentWay& to = to_[receiver * edges() + edge][triangle];
  BentWay way = from.is_silent() ? to : from;
  for (std::size_t wave = 0; wave < 2; ++wave) {
    way.gains.at(wave) = from.gains.at(wave) + weight * (to.gains.at(wave) - from.gains.at(wave));
  }
  if (!from.is_silent() && !to.is_silent()) {
    way.apex += weight * (to.apex - from.apex);
    for (std::size_t wave = 0; wave < 2; ++wave) {
      way.numbers.at(wave) += weight * (to.numbers.at(wave) - from.numbers.at(wave));
    }
  }
  return way;
}

void BentWays::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  for (Ways* ways : {&from_, &to_, &next_}) {
    for (std::size_t k = 0; k < ways->size(); ++k) {
      auto& [apex, gains, numbers] = (*ways)[k][triangle];
      for (double& coordinate : apex) {
        row.value(coordinate);
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
