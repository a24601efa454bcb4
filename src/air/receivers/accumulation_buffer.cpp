#include "idiophone/air/receivers/accumulation_buffer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::receivers {

namespace {

constexpr std::size_t batch_size = 4096;                    // stays in the cache between the two passes over it
constexpr std::size_t sounds_between_carries = 1UL << 23U;  // see FixedPoint::carry

/// Sum of |sound|; NaN if any is.
double find_loudness(std::span<const double> sounds) {
  Lanes4 loudness{};
  for (std::size_t i = 0; i < sounds.size(); i += lane_count) {
    const Lanes4 sound = load(&sounds[i]);
    loudness += sound < 0.0 ? -sound : sound;
  }
  return (loudness[0] + loudness[1]) + (loudness[2] + loudness[3]);
}

/// Whether all are numbers from 0 to `longest`.
bool are_possible(std::span<const double> delays, double longest) {
  const Lanes4 none{};
  IntegerLanes4 wrong{};
  for (std::size_t i = 0; i < delays.size(); i += lane_count) {
    const Lanes4 delay = load(&delays[i]);
    wrong |= ~((delay >= none) & (delay <= longest));
  }
  return (wrong[0] | wrong[1] | wrong[2] | wrong[3]) == 0;
}

/// @throws std::runtime_error for the first that is not
[[noreturn]] void refuse(std::int64_t sample, std::span<const double> delays, double longest) {
  const auto wrong = std::ranges::find_if_not(delays, [&](double delay) { return delay >= 0.0 && delay <= longest; });
  throw std::runtime_error(
      fmt::format("a sound of audio sample {} travels {} audio samples to its receiver; 0 to {} are possible. Is the "
                  "receiver, or a "
                  "body that flew off, too far away?",
                  sample, *wrong, longest));
}

}  // namespace

void AccumulationBuffer::add(std::int64_t sample, const radiation::Arrivals& arrivals) {
  if (sample + spreading_->first() < first_) {
    throw std::logic_error(fmt::format(
        "AccumulationBuffer: the sound of audio sample {} is too late; entries before {} are final", sample, first_));
  }
  const ArrivalBatch all{arrivals.sound, arrivals.change, arrivals.delay};
  const std::size_t total = all.sounds.size();
  if (all.delays.size() != total || (!all.changes.empty() && all.changes.size() != total) || total % lane_count != 0) {
    throw std::logic_error(fmt::format(
        "AccumulationBuffer: found {} sounds, {} changes and {} delays; each number must be the same multiple of {}",
        total, all.changes.size(), all.delays.size(), lane_count));
  }
  if (!all.changes.empty() && !spreading_->differentiates()) {
    throw std::logic_error("AccumulationBuffer: the spreading has no derivative");
  }
  for (std::size_t first = 0; first < total; first += batch_size) {
    const std::size_t count = std::min(batch_size, total - first);
    add_batch(sample,
              {all.sounds.subspan(first, count), all.changes.empty() ? all.changes : all.changes.subspan(first, count),
               all.delays.subspan(first, count)});
  }
}

void AccumulationBuffer::add_batch(std::int64_t sample, const ArrivalBatch& batch) {
  keep_in_range(sample, batch);
  if (!are_possible(batch.delays, longest_delay_)) {
    refuse(sample, batch.delays, longest_delay_);
  }
  const auto density = static_cast<std::int64_t>(spreading_->density());
  const auto offset = static_cast<std::size_t>((sample - first_) * density + spreading_->first_entry());
  const ReachedEntries reached = reached_entries(batch.delays, *spreading_);
  entries_.resize(std::max(entries_.size(), offset + reached.end));
  sums_.add(batch, *spreading_, reached, std::span(entries_).subspan(offset));
}

void AccumulationBuffer::keep_in_range(std::int64_t sample, const ArrivalBatch& batch) {
  constexpr double largest_weight = 1.25, largest_slope = 4.0;  // of any spreading
  const double loudness = largest_weight * find_loudness(batch.sounds) + largest_slope * find_loudness(batch.changes);
  if (added_ + batch.sounds.size() > sounds_between_carries || !(bound_ + loudness <= FixedPoint::limit)) {
    added_ = 0;
    bound_ = 0.0;
    for (FixedPoint& entry : entries_) {
      entry.carry();
      bound_ = std::max(bound_, std::abs(entry.value()));
    }
  }
  added_ += batch.sounds.size();
  bound_ += loudness;
  if (!(bound_ <= FixedPoint::limit)) {
    throw std::runtime_error(fmt::format(
        "the sound of audio sample {} is not finite or above {}: the motion is unstable (is the step too long?)",
        sample, FixedPoint::limit));
  }
}

std::vector<FixedPoint> AccumulationBuffer::take(std::size_t count) {
  const std::size_t taken_entries = count * spreading_->density();
  entries_.resize(std::max(entries_.size(), taken_entries));
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(taken_entries);
  std::vector<FixedPoint> taken(entries_.begin(), end);
  std::ranges::for_each(taken, &FixedPoint::carry);
  entries_.erase(entries_.begin(), end);
  first_ += static_cast<std::int64_t>(count);
  return taken;
}

std::vector<FixedPoint> AccumulationBuffer::pending() const {
  std::vector<FixedPoint> entries = entries_;
  std::ranges::for_each(entries, &FixedPoint::carry);
  return entries;
}

void AccumulationBuffer::restore(std::int64_t first, std::vector<FixedPoint> entries) {
  first_ = first;
  entries_ = std::move(entries);
  added_ = sounds_between_carries;  // so that the next add() finds the bound
}

std::vector<FixedPoint> sum_over_ranks(std::vector<FixedPoint> entries, MPI_Comm communicator) {
  static_assert(sizeof(FixedPoint) == 2 * sizeof(std::int64_t));
  entries.resize(parallel::largest(entries.size(), communicator));
  auto* const words = reinterpret_cast<std::int64_t*>(entries.data());  // NOLINT(*-reinterpret-cast): two words each
  parallel::sum_on_root(std::span(words, 2 * entries.size()), communicator);
  if (!parallel::is_root(communicator)) {
    return {};
  }
  std::ranges::for_each(entries, &FixedPoint::carry);
  return entries;
}

std::vector<double> values(const std::vector<FixedPoint>& entries) {
  std::vector<double> doubles(entries.size());
  std::ranges::transform(entries, doubles.begin(), &FixedPoint::value);
  return doubles;
}

}  // namespace idiophone::receivers
