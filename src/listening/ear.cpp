#include "idiophone/listening/ear.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/lanes.hpp"

namespace idiophone::listening {

namespace {

// A filter's number is that of its direction times this, plus that of its distance, whole metres.
constexpr std::int64_t distances = std::int64_t{1} << 20U;

/// The response of one filter after another.
std::vector<double> chain(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> both(first.size() + second.size() - 1);
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < second.size(); ++k) {
      both[i + k] += first[i] * second[k];
    }
  }
  return both;
}

/// Between the whole metres below and above a distance.
Shares between_metres(double distance) {
  const double within = std::min(radiation::longest_distance, distance);  // beyond, the bank refuses the arrival
  const double below = std::floor(within);
  const auto number = static_cast<std::int64_t>(below);
  return {Share{number, 1.0 - (within - below)}, {number + 1, within - below}};
}

}  // namespace

Ear::Ear(std::int64_t first, double longest_delay, const Spreading& spreading, EarOptions options)
    : head_(std::move(options.head)),
      air_(options.air),
      directions_(head_ ? options.ways : 0, HeadDirections(options.triangles, options.renewal)),
      bank_(first, longest_delay, spreading, filters()) {}

Filters Ear::filters() const {
  if (!head_ && !air_) {
    return Filters::none();
  }
  const std::size_t absorbing_taps = air_ ? 2 * air_->half_width() + 1 : 1;
  const auto make = [head = head_, air = air_](std::int64_t number) {
    Responses responses = head ? head->responses(number / distances) : Responses{{1.0}};
    for (auto& taps : responses) {
      taps = air ? chain(taps, air->response(number % distances)) : taps;
    }
    return responses;
  };
  return {.channels = channels(),
          .taps = (head_ ? head_->taps() : 1) + absorbing_taps - 1,
          .lookahead = lookahead(),
          .make = make};
}

void Ear::hear(std::int64_t sample, std::size_t way, const radiation::Arrivals& arrivals,
               const std::vector<double>& distance, const DirectionOf& direction) {
  if (!head_ && !air_) {
    bank_.add(0, sample, arrivals);
    return;
  }
  if (head_) {
    directions_[way].keep_up(sample, [&](std::size_t triangle) { return head_->nearest(direction(triangle)); });
  }
  for (std::size_t i = 0; i < arrivals.sound.size(); ++i) {
    const bool silent = arrivals.sound[i] == 0.0 && (arrivals.change.empty() || arrivals.change[i] == 0.0);
    if (!silent) {  // nor padding
      share(i, arrivals, distance[i], head_ ? directions_[way].shares(sample, i) : Shares{Share{0, 1.0}});
    }
  }
  for (auto& [filter, part] : parts_) {
    const std::size_t padding = (lane_count - part.sound.size() % lane_count) % lane_count;
    part.sound.resize(part.sound.size() + padding);
    part.delay.resize(part.sound.size());
    part.change.resize(arrivals.change.empty() ? 0 : part.sound.size());
    if (!part.sound.empty()) {
      bank_.add(filter, sample, part);
    }
    for (auto* values : {&part.sound, &part.change, &part.delay}) {
      values->clear();
    }
  }
}

void Ear::share(std::size_t triangle, const radiation::Arrivals& arrivals, double distance, Shares shares) {
  for (const Share& direction : shares) {
    if (!air_) {
      put(direction.number * distances, direction.part, triangle, arrivals);
      continue;
    }
    for (const Share& metre : between_metres(distance)) {
      put(direction.number * distances + metre.number, direction.part * metre.part, triangle, arrivals);
    }
  }
}

void Ear::put(std::int64_t filter, double share, std::size_t triangle, const radiation::Arrivals& arrivals) {
  if (share == 0.0) {
    return;
  }
  radiation::Arrivals& part = parts_[filter];
  part.sound.push_back(share * arrivals.sound[triangle]);
  part.delay.push_back(arrivals.delay[triangle]);
  if (!arrivals.change.empty()) {
    part.change.push_back(share * arrivals.change[triangle]);
  }
}

void Ear::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  for (HeadDirections& directions : directions_) {
    directions.archive(triangle, row);
  }
}

}  // namespace idiophone::listening
