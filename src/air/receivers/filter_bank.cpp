#include "idiophone/air/receivers/filter_bank.hpp"

#include <algorithm>
#include <array>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::receivers {

namespace {

bool is_silent(const std::vector<double>& entries) {
  return std::ranges::all_of(entries, [](double value) { return value == 0.0; });
}

}  // namespace

Filters Filters::none() {
  return {.make = [](std::int64_t) { return Responses{{1.0}}; }};
}

FilterBank::FilterBank(std::int64_t first, double longest_delay, const Spreading& spreading, Filters filters)
    : first_(first - static_cast<std::int64_t>(filters.lookahead + spreading.lookahead())),
      longest_delay_(longest_delay),
      spreading_(&spreading),
      filters_(std::move(filters)) {}

FilterBank::FilterInput& FilterBank::input(std::int64_t number) {
  const auto found = inputs_.find(number);
  if (found != inputs_.end()) {
    return found->second;
  }
  const std::int64_t first = first_ + static_cast<std::int64_t>(lookahead());
  return inputs_
      .emplace(number,
               FilterInput{
                   AccumulationBuffer(first, longest_delay_, *spreading_), std::vector<FixedPoint>(past_entries()), {}})
      .first->second;
}

void FilterBank::add(std::int64_t filter, std::int64_t sample, const radiation::Arrivals& arrivals) {
  input(filter).buffer.add(sample, arrivals);
}

std::vector<std::int64_t> FilterBank::numbers_in_use(MPI_Comm communicator) const {
  std::vector<std::int64_t> own;
  for (const auto& [number, input] : inputs_) {
    own.push_back(number);
  }
  std::vector<std::int64_t> all = parallel::gather_all(std::span<const std::int64_t>(own), communicator).values;
  keep_each_once(all);
  return all;
}

std::vector<std::vector<double>> FilterBank::take(std::size_t count, MPI_Comm communicator) {
  const bool root = parallel::is_root(communicator);
  std::vector<std::vector<double>> sounds(root ? filters_.channels : 0, std::vector<double>(count));
  for (const std::int64_t number : numbers_in_use(communicator)) {
    auto& [buffer, past, responses] = input(number);
    const std::vector<FixedPoint> arrived = sum_over_ranks(buffer.take(count), communicator);
    if (!root) {
      continue;
    }
    past.insert(past.end(), arrived.begin(), arrived.end());
    const std::vector<double> entries = values(past);
    past.erase(past.begin(), past.begin() + static_cast<std::ptrdiff_t>(count * spreading_->density()));
    if (is_silent(entries)) {
      continue;  // adds nothing
    }
    const std::vector<double> input = read_entries(entries, *spreading_);
    if (responses.empty()) {
      responses = filters_.make(number);
    }
    for (std::size_t channel = 0; channel < sounds.size(); ++channel) {
      const std::vector<double> filtered = convolve(input, responses[channel]);
      std::ranges::transform(sounds[channel], filtered, sounds[channel].begin(), std::plus());
    }
  }
  first_ += static_cast<std::int64_t>(count);
  return sounds;
}

void FilterBank::archive(parallel::Archive& archive, const std::string& name) {
  std::vector<std::int64_t> all;
  if (!archive.restoring()) {
    all = words(archive.communicator());
  }
  archive.root(name, all);
  if (archive.restoring()) {
    first_ = all.at(0);
    inputs_.clear();
    if (parallel::is_root(archive.communicator())) {  // the sum over the ranks
      restore_inputs(std::span<const std::int64_t>(all).subspan(1));
    }
  }
}

std::vector<std::int64_t> FilterBank::words(MPI_Comm communicator) const {
  std::vector<std::int64_t> all = {first_};
  for (const std::int64_t number : numbers_in_use(communicator)) {
    const auto found = inputs_.find(number);
    const bool here = found != inputs_.end();
    std::vector<FixedPoint> entries = here ? found->second.past : std::vector<FixedPoint>(past_entries());
    const std::vector<FixedPoint> pending =
        sum_over_ranks(here ? found->second.buffer.pending() : std::vector<FixedPoint>{}, communicator);
    entries.insert(entries.end(), pending.begin(), pending.end());
    all.insert(all.end(), {number, static_cast<std::int64_t>(entries.size())});
    for (const FixedPoint& entry : entries) {
      all.insert(all.end(), {entry.coarse, entry.fine});
    }
  }
  return parallel::is_root(communicator) ? all : std::vector<std::int64_t>{};
}

void FilterBank::restore_inputs(std::span<const std::int64_t> words) {
  auto word = words.begin();
  while (word != words.end()) {
    FilterInput& restored = input(*word++);
    std::vector<FixedPoint> entries(*word++);
    for (FixedPoint& entry : entries) {
      entry.coarse = *word++;
      entry.fine = *word++;
    }
    const auto pending = entries.begin() + static_cast<std::ptrdiff_t>(past_entries());
    restored.past.assign(entries.begin(), pending);
    restored.buffer.restore(restored.buffer.first(), {pending, entries.end()});
  }
}

std::vector<double> read_entries(const std::vector<double>& entries, const Spreading& spreading) {
  const std::size_t density = spreading.density();
  std::vector<double> samples(entries.size() / density - 2 * spreading.lookahead());
  std::vector<double> phase(entries.size() / density);
  for (std::size_t d = 0; d < density; ++d) {
    for (std::size_t n = 0; n < phase.size(); ++n) {
      phase[n] = entries[density * n + d];
    }
    const std::vector<double> filtered = convolve(phase, spreading.entries_to_samples()[d]);
    std::ranges::transform(samples, filtered, samples.begin(), std::plus());
  }
  return samples;
}

std::vector<double> convolve(const std::vector<double>& input, const std::vector<double>& taps) {
  constexpr std::size_t groups = 4;  // of lanes: sums computed at a time
  constexpr std::size_t at_once = groups * lane_count;
  const std::size_t count = input.size() - (taps.size() - 1);
  const std::size_t blocks = (count + at_once - 1) / at_once;
  std::vector<double> padded_input = input;
  padded_input.resize(blocks * at_once + taps.size() - 1);  // whole blocks: every sum is computed alike
  std::vector<double> output(blocks * at_once);
  for (std::size_t first = 0; first < output.size(); first += at_once) {
    std::array<Lanes4, groups> sums{};
    for (std::size_t k = 0; k < taps.size(); ++k) {
      const double* from = &padded_input[first + taps.size() - 1 - k];
      for (std::size_t group = 0; group < groups; ++group) {
        sums[group] += taps[k] * load(from + group * lane_count);
      }
    }
    for (std::size_t group = 0; group < groups; ++group) {
      put(sums[group], &output[first + group * lane_count]);
    }
  }
  output.resize(count);
  return output;
}

}  // namespace idiophone::receivers
