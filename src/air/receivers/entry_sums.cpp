#include "idiophone/air/receivers/entry_sums.hpp"

#include <algorithm>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::receivers {

namespace {

/// What one of the arrivals adds to the entries of a group.
template <class Lanes, bool with_changes>
Lanes taps_of(const ArrivalBatch& batch, std::size_t i, const Spreading::Weights& weights,
              const Spreading::ArrivalCell& cell, std::size_t group) {
  Lanes taps = batch.sounds[i] * weights.sound<Lanes>(cell, group);
  if constexpr (with_changes) {
    taps += batch.changes[i] * weights.change<Lanes>(cell, group);
  }
  return taps;
}

/// Few sounds in many entries.
void add_one_by_one(const ArrivalBatch& batch, const Spreading& spreading, std::span<FixedPoint> entries) {
  const Spreading::Weights weights = spreading.weights();
  const auto density = static_cast<double>(spreading.density());
  for (std::size_t i = 0; i < batch.sounds.size(); ++i) {
    const Spreading::ArrivalCell cell = Spreading::cell_of(density * batch.delays[i]);
    for (std::size_t group = 0; group < spreading.width() / lane_count; ++group) {
      const Lanes4 taps = batch.changes.empty() ? taps_of<Lanes4, false>(batch, i, weights, cell, group)
                                                : taps_of<Lanes4, true>(batch, i, weights, cell, group);
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        entries[static_cast<std::size_t>(cell.before) + lane_count * group + lane] += FixedPoint::from(taps[lane]);
      }
    }
  }
}

}  // namespace

ReachedEntries reached_entries(std::span<const double> delays, const Spreading& spreading) {
  Lanes4 shortest = load(delays.data()), longest = shortest;
  for (std::size_t i = lane_count; i < delays.size(); i += lane_count) {
    const Lanes4 delay = load(&delays[i]);
    shortest = delay < shortest ? delay : shortest;
    longest = delay > longest ? delay : longest;
  }
  const auto before = [density = static_cast<double>(spreading.density())](double delay) {
    return static_cast<std::size_t>(Spreading::cell_of(density * delay).before);
  };
  return {before(std::min({shortest[0], shortest[1], shortest[2], shortest[3]})),
          before(std::max({longest[0], longest[1], longest[2], longest[3]})) + spreading.width()};
}

void EntrySums::add(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
                    std::span<FixedPoint> entries) {
  if (reached.end - reached.begin > batch.sounds.size()) {
    add_one_by_one(batch, spreading, entries);
  } else if (spreading.width() % wide_count == 0) {
    add<WideLanes>(batch, spreading, reached, entries);
  } else {
    add<Lanes4>(batch, spreading, reached, entries);
  }
}

template <class Lanes>
void EntrySums::add(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
                    std::span<FixedPoint> entries) {
  const std::size_t count = reached.end - reached.begin;
  for (auto* sums : {&coarse_, &fine_}) {
    sums->assign(turns * count, 0);
  }
  if (batch.changes.empty()) {
    sum<Lanes, false>(batch, spreading, reached);
  } else {
    sum<Lanes, true>(batch, spreading, reached);
  }
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < count; ++i) {
      entries[reached.begin + i] += {coarse_[turn * count + i], fine_[turn * count + i]};
    }
  }
}

template <class Lanes, bool with_changes>
void EntrySums::sum(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached) {
  using Integers = decltype(Lanes{} < Lanes{});
  constexpr std::size_t lanes = sizeof(Lanes) / sizeof(double);
  const std::size_t groups = spreading.width() / lanes;
  const std::size_t count = reached.end - reached.begin;
  const Spreading::Weights weights = spreading.weights();
  const auto density = static_cast<double>(spreading.density());
  const ArrivalBatch arrivals = batch;  // a copy of its own, as the weights
  std::int64_t* const coarse_sums = coarse_.data();
  std::int64_t* const fine_sums = fine_.data();
  const std::size_t begin = reached.begin;
  std::size_t first = 0;  // of the turn
  for (std::size_t i = 0; i < arrivals.sounds.size(); ++i) {
    const Spreading::ArrivalCell cell = Spreading::cell_of(density * arrivals.delays[i]);
    const std::size_t place = first + static_cast<std::size_t>(cell.before) - begin;
    first = first == (turns - 1) * count ? 0 : first + count;
    std::int64_t* coarse = coarse_sums + place;
    std::int64_t* fine = fine_sums + place;
    for (std::size_t group = 0; group < groups; ++group) {
      const Cut<Integers, Lanes> cut(taps_of<Lanes, with_changes>(arrivals, i, weights, cell, group));
      put(load<Integers>(coarse + lanes * group) + cut.coarse, coarse + lanes * group);
      put(load<Integers>(fine + lanes * group) + cut.fine, fine + lanes * group);
    }
  }
}

}  // namespace idiophone::receivers
