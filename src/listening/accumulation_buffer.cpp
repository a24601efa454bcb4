#include "idiophone/listening/accumulation_buffer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/lanes.hpp"
#include "idiophone/listening/splat.hpp"

namespace idiophone::listening {

namespace {

constexpr std::size_t part_size = 4096;                     // stays in the cache between the two passes over it
constexpr std::size_t sounds_between_carries = 1UL << 23U;  // see FixedPoint::carry

/// Sum of |sound|; NaN if any is.
double find_loudness(std::span<const double> sounds) {
  Lanes loudness{};
  for (std::size_t i = 0; i < sounds.size(); i += lane_count) {
    const Lanes sound = load(&sounds[i]);
    loudness += sound < 0.0 ? -sound : sound;
  }
  return (loudness[0] + loudness[1]) + (loudness[2] + loudness[3]);
}

/// The longest of delays that are all at least 0.
double find_longest(std::span<const double> delays) {
  Lanes longest{};
  for (std::size_t i = 0; i < delays.size(); i += lane_count) {
    const Lanes delay = load(&delays[i]);
    longest = delay > longest ? delay : longest;
  }
  return std::max({longest[0], longest[1], longest[2], longest[3]});
}

/// Adds the taps' whole numbers to four entries, which lie there as coarse, fine, coarse, fine, ...
void add_taps(const Lanes& taps, FixedPoint* entries) {
  const Cut<IntegerLanes, Lanes> cut(taps);
  auto* words = &entries->coarse;
  put(load<IntegerLanes>(words) + __builtin_shufflevector(cut.coarse, cut.fine, 0, 4, 1, 5), words);
  words += lane_count;
  put(load<IntegerLanes>(words) + __builtin_shufflevector(cut.coarse, cut.fine, 2, 6, 3, 7), words);
}

}  // namespace

void AccumulationBuffer::add(std::int64_t sample, const radiation::Arrivals& arrivals) {
  if (sample + first_written < first_) {
    throw std::logic_error(fmt::format(
        "AccumulationBuffer: a sound of audio sample {} comes too late, entries from {} on are open", sample, first_));
  }
  const std::span<const double> sounds = arrivals.sound;
  const std::span<const double> delays = arrivals.delay;
  if (sounds.size() != delays.size() || sounds.size() % lane_count != 0) {
    throw std::logic_error(
        fmt::format("AccumulationBuffer: {} sounds with {} delays; a multiple of {} each was expected", sounds.size(),
                    delays.size(), lane_count));
  }
  for (std::size_t first = 0; first < sounds.size(); first += part_size) {
    const std::size_t count = std::min(part_size, sounds.size() - first);
    add_part(sample, sounds.subspan(first, count), delays.subspan(first, count));
  }
}

void AccumulationBuffer::add_part(std::int64_t sample, std::span<const double> sounds, std::span<const double> delays) {
  keep_in_range(sample, sounds);
  const auto wrong =
      std::ranges::find_if_not(delays, [this](double delay) { return delay >= 0.0 && delay <= longest_delay_; });
  if (wrong != delays.end()) {
    throw std::runtime_error(
        fmt::format("a sound of audio sample {} travels {} audio samples to its receiver; 0 to {} are possible. Is the "
                    "receiver, or "
                    "a body that flew off, too far away?",
                    sample, *wrong, longest_delay_));
  }
  const auto offset = static_cast<std::size_t>(sample + first_written - first_);
  const auto longest = static_cast<std::size_t>(find_longest(delays));
  entries_.resize(std::max(entries_.size(), offset + longest + lane_count));

  const Splat& splat = Splat::instance();
  FixedPoint* entries = &entries_[offset];
  for (std::size_t i = 0; i < sounds.size(); ++i) {
    const Splat::Taps taps = splat.taps(delays[i]);
    add_taps(sounds[i] * taps.weights, entries + taps.before);
  }
}

void AccumulationBuffer::keep_in_range(std::int64_t sample, std::span<const double> sounds) {
  const double loudness = find_loudness(sounds);
  if (added_ + sounds.size() > sounds_between_carries || !(bound_ + loudness <= FixedPoint::limit)) {
    added_ = 0;
    bound_ = 0.0;
    for (FixedPoint& entry : entries_) {
      entry.carry();
      bound_ = std::max(bound_, std::abs(entry.value()));
    }
  }
  added_ += sounds.size();
  bound_ += loudness;
  if (!(bound_ <= FixedPoint::limit)) {
    throw std::runtime_error(fmt::format(
        "the sound of audio sample {} is not finite or above {}: the motion is unstable (is the step too long?)",
        sample, FixedPoint::limit));
  }
}

std::vector<FixedPoint> AccumulationBuffer::take(std::size_t count) {
  entries_.resize(std::max(entries_.size(), count));
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(count);
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
  added_ = sounds_between_carries;  // so that the next add finds the bound
}

std::vector<FixedPoint> sum_over_ranks(std::vector<FixedPoint> entries, MPI_Comm communicator) {
  static_assert(sizeof(FixedPoint) == 2 * sizeof(std::int64_t));
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::uint64_t count = entries.size();
  MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_UINT64_T, MPI_MAX, communicator);
  entries.resize(count);
  constexpr std::size_t at_once = 1UL << 24U;  // MPI counts are 32-bit
  for (std::size_t first = 0; first < count; first += at_once) {
    void* words = &entries[first];
    const int length = static_cast<int>(2 * std::min(at_once, count - first));
    MPI_Reduce(rank == 0 ? MPI_IN_PLACE : words, words, length, MPI_INT64_T, MPI_SUM, 0, communicator);
  }
  if (rank != 0) {
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

}  // namespace idiophone::listening
