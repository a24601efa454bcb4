#include "idiophone/air/receivers/entry_sums.hpp"

#include <algorithm>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::receivers {

namespace {

/// One of the arrivals.
ArrivalBatch one_of(const ArrivalBatch& batch, std::size_t i) {
  return {batch.sounds.subspan(i, 1), batch.changes.empty() ? batch.changes : batch.changes.subspan(i, 1),
          batch.delays.subspan(i, 1)};
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
  const bool are_apart = reached.end - reached.begin > batch.sounds.size();
  for (std::size_t i = 0; are_apart && i < batch.sounds.size(); ++i) {
    const auto cell = Spreading::cell_of(static_cast<double>(spreading.density()) * batch.delays[i]);
    const auto begin = static_cast<std::size_t>(cell.before);
    add_near(one_of(batch, i), spreading, {begin, begin + spreading.width()}, entries);
  }
  if (!are_apart) {
    add_near(batch, spreading, reached, entries);
  }
}

void EntrySums::add_near(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
                         std::span<FixedPoint> entries) {
  const std::size_t count = reached.end - reached.begin;
  const std::size_t turns = std::min(most_turns, batch.sounds.size());
  for (auto* sums : {&coarse_, &fine_}) {
    sums->assign(turns * count, 0);
  }
  const bool fits = spreading.width() % wide_count == 0;
  if (batch.changes.empty()) {
    fits ? sum<WideLanes, false>(batch, spreading, reached) : sum<Lanes4, false>(batch, spreading, reached);
  } else {
    fits ? sum<WideLanes, true>(batch, spreading, reached) : sum<Lanes4, true>(batch, spreading, reached);
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
  const ArrivalBatch arrivals = batch;  // a copy of its own, as that of the weights
  std::int64_t* const coarse_sums = coarse_.data();
  std::int64_t* const fine_sums = fine_.data();
  const std::size_t begin = reached.begin;
  const std::size_t last = coarse_.size() - count;
  std::size_t first = 0;  // of the turn
  for (std::size_t i = 0; i < arrivals.sounds.size(); ++i) {
    const Spreading::ArrivalCell cell = Spreading::cell_of(density * arrivals.delays[i]);
    const std::size_t place = first + static_cast<std::size_t>(cell.before) - begin;
    first = first == last ? 0 : first + count;
    std::int64_t* coarse = coarse_sums + place;
    std::int64_t* fine = fine_sums + place;
    for (std::size_t group = 0; group < groups; ++group) {
      Lanes taps = arrivals.sounds[i] * weights.sound<Lanes>(cell, group);
      if constexpr (with_changes) {
        taps += arrivals.changes[i] * weights.change<Lanes>(cell, group);
      }
      const Cut<Integers, Lanes> cut(taps);
      put(load<Integers>(coarse + lanes * group) + cut.coarse, coarse + lanes * group);
      put(load<Integers>(fine + lanes * group) + cut.fine, fine + lanes * group);
    }
  }
}

}  // namespace idiophone::receivers
