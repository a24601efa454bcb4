#include "idiophone/air/propagation/bent_ways.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::propagation {

namespace {

/// A place beside an edge, for rays that pass it.
Vector3 beside(const radiation::DiffractingEdge& edge, const Vector3& apex) {
  constexpr double gap = 1e-4;  // of the edge's length
  return apex + gap * edge.length() * edge.outward();
}

/// Whether all edges of a way are in the air, and nothing blocks it.
bool is_open(const radiation::EdgesInTurn& edges, const radiation::Bend& bend, const DiffractingEdges& all,
             std::size_t copy, const FoldedSight& sight, Index triangle, const Vector3& end) {
  std::vector<Vector3> corners;
  for (std::size_t i = 0; i < edges.count; ++i) {
    corners.push_back(beside(edges.edges.at(i), bend.apexes.at(i)));
    if (!sight.is_in_air(all.mirrored(corners.back(), copy)) ||
        (i > 0 && !sight.is_clear(corners[i - 1], corners[i]))) {
      return false;
    }
  }
  return sight.sees(triangle, corners.front()) && sight.is_clear(corners.back(), end);
}

void archive_way(BentWay& way, parallel::ArchiveRow& row) {
  for (Vector3& apex : way.apexes) {
    row.values(apex);
  }
  row.value(way.between);
  row.value(way.gain);
  for (auto& waves : way.waves) {
    for (receivers::NumberedWave& wave : waves) {
      row.value(wave.gain);
      row.value(wave.number);
    }
  }
}

}  // namespace

BentWays::BentWays(Options options, std::size_t receivers, std::size_t triangles)
    : options_(std::move(options)), triangles_(triangles), next_(receivers * options_.paths.size()) {
  start();
}

void BentWays::find(const DiffractingEdges& edges, const FoldedSight& sight, std::span<const Index> triangles,
                    std::span<const Vector3> ends, std::size_t paths) {
  for (std::size_t k = 0; k < next_.size(); ++k) {
    const auto& [path, copies] = options_.paths[k % options_.paths.size()];
    const Vector3& end = ends[k / options_.paths.size() * paths + path];
    next_[k].clear();
    for (const std::size_t copy : copies) {
      for (const radiation::EdgeSequence& sequence : edges.sequences()) {
        find_around(edges, sequence, copy, sight, triangles, end, next_[k]);
      }
    }
  }
}

void BentWays::find_around(const DiffractingEdges& edges, const radiation::EdgeSequence& sequence, std::size_t copy,
                           const FoldedSight& sight, std::span<const Index> triangles, const Vector3& end,
                           WaysToEnd& found) const {
  const radiation::EdgesInTurn in_turn = edges.placed(sequence, copy);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (edges.is_own(sequence, triangles[i])) {
      continue;
    }
    const Vector3 source = sight.visibility().centre(triangles[i]);
    const radiation::Bend bend = radiation::find_bend(in_turn, source, end, options_.speed);
    if (bend.gain > 0.0 && is_open(in_turn, bend, edges, copy, sight, triangles[i], end)) {
      std::vector<BentWay>& ways = found[DiffractingEdges::number(sequence, copy)];
      ways.resize(triangles_);
      ways[i] = numbered(bend, in_turn.count);
    }
  }
}

BentWay BentWays::numbered(const radiation::Bend& bend, std::size_t count) const {
  BentWay way{.apexes = {bend.apexes[0], bend.apexes.at(count - 1)}, .gain = bend.gain};
  for (std::size_t i = 0; i < count; ++i) {
    way.between += i > 0 ? (bend.apexes.at(i) - bend.apexes.at(i - 1)).norm() : 0.0;
    std::ranges::transform(bend.waves.at(i), way.waves.at(i).begin(), [&](const radiation::EdgeWave& wave) {
      return receivers::NumberedWave{wave.gain, receivers::EdgeFilters::number_of(wave.delay * options_.rate)};
    });
  }
  return way;
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
  heard_.assign(from_.size(), {});
  for (std::size_t k = 0; k < from_.size(); ++k) {
    for (const Ways* ways : {&from_, &to_}) {
      std::ranges::transform((*ways)[k], std::back_inserter(heard_[k]), &WaysToEnd::value_type::first);
    }
    keep_each_once(heard_[k]);
  }
}

std::optional<std::size_t> BentWays::place_of(std::size_t receiver, std::size_t path) const {
  const auto bent = std::ranges::find(options_.paths, path, &Path::number);
  if (bent == options_.paths.end()) {
    return std::nullopt;
  }
  return receiver * options_.paths.size() + static_cast<std::size_t>(bent - options_.paths.begin());
}

std::span<const std::int64_t> BentWays::heard(std::size_t receiver, std::size_t path) const {
  const auto place = place_of(receiver, path);
  return place ? std::span<const std::int64_t>(heard_[*place]) : std::span<const std::int64_t>();
}

BentWay BentWays::at(double weight, std::size_t receiver, std::size_t path, std::int64_t way,
                     std::size_t triangle) const {
  const std::size_t place = place_of(receiver, path).value();
  const auto in = [&](const Ways& ways) {  // what is not there is silent
    const auto found = ways[place].find(way);
    return found == ways[place].end() ? BentWay() : found->second[triangle];
  };
  const BentWay from = in(from_), to = in(to_);
  BentWay now = from.gain == 0.0 ? to : from;
  const auto cross = [weight](auto& value, const auto& begin, const auto& end) {
    value = begin + weight * (end - begin);
  };
  cross(now.gain, from.gain, to.gain);
  if (from.gain == 0.0 || to.gain == 0.0) {
    return now;
  }
  cross(now.between, from.between, to.between);
  for (std::size_t k = 0; k < now.apexes.size(); ++k) {
    cross(now.apexes.at(k), from.apexes.at(k), to.apexes.at(k));
  }
  for (std::size_t edge = 0; edge < now.waves.size(); ++edge) {
    for (std::size_t k = 0; k < 2; ++k) {
      const receivers::NumberedWave &begin = from.waves.at(edge).at(k), &end = to.waves.at(edge).at(k);
      cross(now.waves.at(edge).at(k).gain, begin.gain, end.gain);
      cross(now.waves.at(edge).at(k).number, begin.number, end.number);
    }
  }
  return now;
}

void BentWays::archive(parallel::Archive& archive, const parallel::Rows& triangles) {
  if (next_.empty()) {
    return;
  }
  std::vector<WaysToEnd*> stages;  // before, now and next, of each end
  for (Ways* ways : {&from_, &to_, &next_}) {
    std::ranges::transform(*ways, std::back_inserter(stages), [](WaysToEnd& found) { return &found; });
  }
  const auto count = static_cast<std::int64_t>(stages.size());
  std::vector<std::int64_t> numbers;  // of the ways that any rank has, each with its stage
  for (std::int64_t stage = 0; stage < count; ++stage) {
    std::ranges::transform(*stages[stage], std::back_inserter(numbers),
                           [&](const auto& way) { return way.first * count + stage; });
    if (archive.restoring()) {
      stages[stage]->clear();
    }
  }
  numbers = parallel::gather_all(std::span<const std::int64_t>(numbers), archive.communicator()).values;
  keep_each_once(numbers);
  archive.root("radiation/way_numbers", numbers);
  for (const std::int64_t number : numbers) {
    (*stages[number % count])[number / count].resize(triangles_);  // silent where they are new
  }
  archive.rows("radiation/ways", triangles, [&](std::size_t triangle, parallel::ArchiveRow& row) {
    for (const std::int64_t number : numbers) {
      archive_way((*stages[number % count])[number / count][triangle], row);
    }
  });
  note_heard();
}

}  // namespace idiophone::propagation
