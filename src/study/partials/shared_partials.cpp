#include "idiophone/study/partials/shared_partials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "shared_fit.hpp"

namespace idiophone::partials {

namespace {

/// A partial of one recording.
struct Candidate {
  std::size_t recording = 0;
  double frequency = 0.0;  ///< Hz
  double decay = 0.0;      ///< of the amplitude, 1/s
  double reach = 0.0;      ///< Hz, within which a partial of another recording is the same
  double weight = 0.0;     ///< power over the noise, which is one over the variance
};

std::vector<Candidate> candidates_of(const std::vector<std::vector<double>>& recordings, double rate,
                                     const PartialOptions& options) {
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < recordings.size(); ++k) {
    const double bin = 0.5 * rate / static_cast<double>(recordings[k].size());  // Hz
    for (const Partial& partial : find_partials(recordings[k], rate, options).found) {
      if (!partial.decay_time) {
        continue;
      }
      const double decay = std::log(1000.0) / *partial.decay_time;
      const double half_width = decay / (2.0 * std::numbers::pi);
      candidates.push_back({.recording = k,
                            .frequency = partial.frequency,
                            .decay = decay,
                            .reach = std::max({bin, half_width, 3.0 * partial.frequency_deviation}),
                            .weight = std::pow(10.0, 0.1 * partial.prominence)});
    }
  }
  std::ranges::stable_sort(candidates, std::greater(), &Candidate::weight);
  return candidates;
}

/// Candidates of different recordings that are one partial, the strongest first.
using Joined = std::vector<Candidate>;

bool belongs_to(const Candidate& candidate, const Joined& joined) {
  const Candidate& strongest = joined.front();
  return std::abs(candidate.frequency - strongest.frequency) < std::max(candidate.reach, strongest.reach) &&
         std::ranges::find(joined, candidate.recording, &Candidate::recording) == joined.end();
}

std::vector<Joined> join(const std::vector<Candidate>& candidates) {
  std::vector<Joined> all;
  for (const Candidate& candidate : candidates) {
    Joined* nearest = nullptr;
    const auto distance = [&](const Joined& joined) {
      return std::abs(candidate.frequency - joined.front().frequency);
    };
    for (Joined& joined : all) {
      if (belongs_to(candidate, joined) && (nearest == nullptr || distance(joined) < distance(*nearest))) {
        nearest = &joined;
      }
    }
    if (nearest != nullptr) {
      nearest->push_back(candidate);
    } else {
      all.push_back({candidate});
    }
  }
  return all;
}

SharedLine line_of(const Joined& joined, double rate) {
  double weight = 0.0, frequency = 0.0, decay = 0.0;
  for (const Candidate& candidate : joined) {
    weight += candidate.weight;
    frequency += candidate.weight * candidate.frequency;
    decay += candidate.weight * candidate.decay;
  }
  return {.line = {.frequency = 2.0 * std::numbers::pi * frequency / (weight * rate),
                   .damping = decay / (weight * rate),
                   .amplitude = 1.0},
          .amplitude = {}};
}

}  // namespace

std::vector<SharedPartial> find_shared_partials(const std::vector<std::vector<double>>& recordings, double rate,
                                                const PartialOptions& options) {
  for (const std::vector<double>& samples : recordings) {
    if (samples.size() != recordings.front().size()) {
      throw std::invalid_argument("recordings whose partials are to be shared must have one length");
    }
  }
  std::vector<SharedLine> lines;
  for (const Joined& joined : join(candidates_of(recordings, rate, options))) {
    lines.push_back(line_of(joined, rate));
  }
  if (lines.empty()) {
    return {};
  }
  const LineSpectrum line_spectrum(recordings.front().size());
  std::vector<SharedLine> fitted = SharedFit(line_spectrum, recordings, std::move(lines)).fit();
  std::vector<SharedPartial> partials;
  for (SharedLine& shared : fitted) {
    if (shared.line.frequency > 0.0 && shared.line.damping > 0.0) {
      partials.push_back({.frequency = shared.line.frequency * rate / (2.0 * std::numbers::pi),
                          .decay = shared.line.damping * rate,
                          .amplitude = std::move(shared.amplitude)});
    }
  }
  return partials;
}

}  // namespace idiophone::partials
