#include "idiophone/air/receivers/entry_sums.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::receivers {

namespace {

/// One of the arrivals, and silent ones beside it.
struct Alone {
  std::array<double, lane_count> sounds = {}, changes = {}, delays = {};

  Alone(const ArrivalBatch& batch, std::size_t i) {
    sounds[0] = batch.sounds[i];
    changes[0] = batch.changes.empty() ? 0.0 : batch.changes[i];
    delays.fill(batch.delays[i]);
  }

  [[nodiscard]] ArrivalBatch batch(bool with_changes) const {
    return {sounds, with_changes ? std::span<const double>(changes) : std::span<const double>(), delays};
  }
};

/// [width] sums of a row.
template <class Rows>
auto* row_of(Rows& rows, std::size_t row, std::size_t width) {
  return rows.data()->values.data() + row * width;
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
    add_near<1>(Alone(batch, i).batch(!batch.changes.empty()), spreading, {begin, begin + spreading.width()}, entries);
  }
  if (!are_apart) {
    add_near<lane_count>(batch, spreading, reached, entries);
  }
}

template <std::size_t used>
void EntrySums::add_near(const ArrivalBatch& batch, const Spreading& spreading, const ReachedEntries& reached,
                         std::span<FixedPoint> entries) {
  const std::size_t width = spreading.width();
  const std::size_t rows = reached.end - reached.begin - width + 1;
  for (auto* sums : {&coarse_, &fine_}) {
    sums->assign(padded(rows * width) / pack_size, AlignedIntegers{});
  }
  if (width == pack_size) {
    batch.changes.empty() ? sum<pack_size, false, used>(batch, spreading, reached.begin)
                          : sum<pack_size, true, used>(batch, spreading, reached.begin);
  } else {
    sum<lane_count, false, used>(batch, spreading, reached.begin);
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < width; ++i) {
      entries[reached.begin + row + i] += {row_of(coarse_, row, width)[i], row_of(fine_, row, width)[i]};
    }
  }
}

template <std::size_t width, bool with_changes, std::size_t used>
void EntrySums::sum(const ArrivalBatch& batch, const Spreading& spreading, std::size_t begin) {
  using Lanes = std::conditional_t<width % wide_count == 0, WideLanes, Lanes4>;
  using Integers = decltype(Lanes{} < Lanes{});
  constexpr std::size_t lanes = sizeof(Lanes) / sizeof(double);
  const Spreading::Weights weights = spreading.weights();
  const auto density = static_cast<double>(spreading.density());
  const ArrivalBatch arrivals = batch;  // a copy of its own, as that of the weights
  std::int64_t* const coarse_sums = row_of(coarse_, 0, width);
  std::int64_t* const fine_sums = row_of(fine_, 0, width);
  for (std::size_t i = 0; i < arrivals.sounds.size(); i += lane_count) {
    const Spreading::ArrivalCells cells(density * load(&arrivals.delays[i]));
    Spreading::Weights::Factors factors;
    if constexpr (with_changes) {
      factors = weights.factors(cells, load(&arrivals.sounds[i]), load(&arrivals.changes[i]));
    }
    for (std::size_t lane = 0; lane < used; ++lane) {
      const Spreading::ArrivalCell cell = cells[lane];
      const std::size_t place = (static_cast<std::size_t>(cell.before) - begin) * width;
      for (std::size_t group = 0; group < width / lanes; ++group) {
        Lanes taps;
        if constexpr (with_changes) {
          taps = weights.sum<Lanes>(cell, group, factors, lane);
        } else {
          taps = arrivals.sounds[i + lane] * weights.sound<Lanes>(cell, group);
        }
        const Cut<Integers, Lanes> cut(taps);
        std::int64_t* const coarse = coarse_sums + place + lanes * group;
        std::int64_t* const fine = fine_sums + place + lanes * group;
        put(load<Integers>(coarse) + cut.coarse, coarse);
        put(load<Integers>(fine) + cut.fine, fine);
      }
    }
  }
}

}  // namespace idiophone::receivers
