#include "idiophone/air/receivers/ear.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/foundation/lanes.hpp"
#include "in_series.hpp"

namespace idiophone::receivers {

namespace {

// The number of a filter counts whole metres, then directions, then paths, then edges.
constexpr std::int64_t distances = std::int64_t{1} << 20U;

std::int64_t direction_count(const std::shared_ptr<const HeadResponses>& head) {
  return head ? static_cast<std::int64_t>(head->count()) : 1;
}

/// Padding is silent, too.
bool is_silent(const radiation::Arrivals& arrivals, std::size_t i) {
  return arrivals.sound[i] == 0.0 && (arrivals.change.empty() || arrivals.change[i] == 0.0);
}

/// Adds a part of one sound to the input of a filter.
void append(radiation::Arrivals& input, double weight, std::size_t triangle, const radiation::Arrivals& arrivals) {
  if (weight == 0.0) {
    return;
  }
  input.sound.push_back(weight * arrivals.sound[triangle]);
  input.delay.push_back(arrivals.delay[triangle]);
  if (!arrivals.change.empty()) {
    input.change.push_back(weight * arrivals.change[triangle]);
  }
}

/// Linear interpolation between the whole metres below and above a distance.
Crossfade between_metres(double distance) {
  const double within = std::min(radiation::longest_distance, distance);  // the filter bank throws for longer ones
  const double below = std::floor(within);
  const auto number = static_cast<std::int64_t>(below);
  return {FilterWeight{number, 1.0 - (within - below)}, {number + 1, within - below}};
}

}  // namespace

Ear::Ear(std::int64_t first, double longest_delay, const Spreading& spreading, EarOptions options)
    : head_(std::move(options.head)),
      air_(options.air),
      walls_(std::move(options.walls)),
      edges_(options.edges),
      paths_(walls_ ? options.paths : 1),
      directions_(head_ ? options.paths : 0, HeadDirections(options.triangles, options.direction_interval)),
      bank_(first, longest_delay, spreading, filters()) {}

std::int64_t Ear::number_of(const Losses& losses) const {
  const auto path =
      (static_cast<std::int64_t>(paths_) * losses.edge) + static_cast<std::int64_t>(walls_ ? losses.path : 0);
  return (path * direction_count(head_) + losses.direction) * distances + losses.metres;
}

Filters Ear::filters() const {
  if (!head_ && !air_ && !walls_ && !edges_) {
    return Filters::none();
  }
  const std::size_t half_width = (air_ ? air_->half_width() : 0) + (walls_ ? walls_->half_width() : 0);
  const auto make = [head = head_, air = air_, walls = walls_, edges = edges_,
                     paths = static_cast<std::int64_t>(paths_)](std::int64_t number) {
    const std::int64_t directions = direction_count(head);
    Responses responses = head ? head->responses(number / distances % directions) : Responses{{1.0}};
    for (auto& taps : responses) {
      taps = air ? in_series(taps, air->response(number % distances)) : taps;
      taps = walls ? in_series(taps, walls->response(number / distances / directions % paths)) : taps;
      taps = edges ? in_series(taps, edges->response(number / distances / directions / paths)) : taps;
    }
    return responses;
  };
  return {.channels = channels(),
          .taps = (head_ ? head_->taps() : 1) + 2 * half_width + (edges_ ? edges_->taps() - 1 : 0),
          .lookahead = half_width + (edges_ ? edges_->lookahead() : 0),
          .make = make};
}

void Ear::hear(std::int64_t sample, std::size_t path, const radiation::Arrivals& arrivals,
               const std::vector<double>& distance, const DirectionOf& direction) {
  if (!head_ && !air_) {
    bank_.add(number_of({.path = path}), sample, arrivals);
    return;
  }
  if (head_) {
    directions_[path].update(sample, [&](std::size_t triangle) { return head_->nearest(direction(triangle)); });
  }
  for (std::size_t i = 0; i < arrivals.sound.size(); ++i) {
    if (!is_silent(arrivals, i)) {
      distribute({.path = path}, 1.0, i, arrivals, distance[i], directions(sample, path, i));
    }
  }
  add_inputs(sample, !arrivals.change.empty());
}

void Ear::hear_around(std::int64_t sample, std::size_t path, const radiation::Arrivals& arrivals,
                      const std::vector<double>& distance, std::span<const WavesInTurn> waves) {
  for (std::size_t i = 0; i < arrivals.sound.size(); ++i) {
    if (is_silent(arrivals, i)) {
      continue;
    }
    for (const FilterWeight& edges : edges_->filters_of(waves[i])) {
      distribute({.path = path, .edge = edges.number}, edges.weight, i, arrivals, distance[i],
                 directions(sample, path, i));
    }
  }
  add_inputs(sample, !arrivals.change.empty());
}

Crossfade Ear::directions(std::int64_t sample, std::size_t path, std::size_t triangle) const {
  return head_ ? directions_[path].crossfade(sample, triangle) : Crossfade{FilterWeight{0, 1.0}};
}

void Ear::add_inputs(std::int64_t sample, bool with_changes) {
  for (auto& [filter, input] : inputs_) {
    add_input(filter, input, sample, with_changes);
  }
}

void Ear::add_input(std::int64_t filter, radiation::Arrivals& input, std::int64_t sample, bool with_changes) {
  if (input.sound.empty()) {
    return;
  }
  const std::size_t padding = (lane_count - input.sound.size() % lane_count) % lane_count;
  input.sound.resize(input.sound.size() + padding);
  input.delay.resize(input.sound.size(), input.delay.back());  // as the others, so that they reach the same entries
  input.change.resize(with_changes ? input.sound.size() : 0);
  bank_.add(filter, sample, input);
  for (auto* values : {&input.sound, &input.change, &input.delay}) {
    values->clear();
  }
}

void Ear::distribute(Losses losses, double weight, std::size_t triangle, const radiation::Arrivals& arrivals,
                     double distance, const Crossfade& directions) {
  for (const FilterWeight& direction : directions) {
    losses.direction = direction.number;
    if (!air_) {
      add_to_filter({number_of(losses), weight * direction.weight}, triangle, arrivals);
      continue;
    }
    for (const FilterWeight& metre : between_metres(distance)) {
      losses.metres = metre.number;
      add_to_filter({number_of(losses), weight * direction.weight * metre.weight}, triangle, arrivals);
    }
  }
}

void Ear::add_to_filter(FilterWeight filter, std::size_t triangle, const radiation::Arrivals& arrivals) {
  append(inputs_[filter.number], filter.weight, triangle, arrivals);
}

void Ear::archive(std::size_t triangle, parallel::ArchiveRow& row) {
  for (HeadDirections& directions : directions_) {
    directions.archive(triangle, row);
  }
}

}  // namespace idiophone::receivers
