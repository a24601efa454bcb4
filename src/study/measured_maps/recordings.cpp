#include "recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "idiophone/foundation/spectra/sound_file.hpp"

namespace idiophone::measured_maps {

namespace {

using deck::DeckError;

constexpr double shortest = 0.05;    // s, of what can be analysed
constexpr double clearance = 0.001;  // s, from the end of the force, so that nothing but the body's modes is left

double largest(const std::vector<double>& samples) {
  double peak = 0.0;
  for (const double sample : samples) {
    peak = std::max(peak, std::abs(sample));
  }
  return peak;
}

/// The first of three equal samples at full scale; none if there are none.
std::optional<std::size_t> clipped_at(const std::vector<double>& samples) {
  constexpr double limit = 0.99;
  const double peak = largest(samples);
  for (std::size_t n = 2; peak >= limit && n < samples.size(); ++n) {
    if (std::abs(samples[n]) == peak && samples[n - 1] == samples[n] && samples[n - 2] == samples[n]) {
      return n - 2;
    }
  }
  return std::nullopt;
}

void check_samples(const spectra::SoundFile& file, const RecordedBlow& blow) {
  const auto refuse = [&](const std::string& problem) {
    throw DeckError(blow.sound_where, fmt::format("{}: {}", blow.sound.string(), problem));
  };
  for (std::size_t channel = 0; channel < file.channels.size(); ++channel) {
    const std::vector<double>& samples = file.channels[channel];
    if (!std::ranges::all_of(samples, [](double sample) { return std::isfinite(sample); })) {
      refuse("has samples that are not finite");
    }
    if (largest(samples) < 1e-7) {
      refuse(fmt::format("channel {} is silent", channel + 1));
    }
    if (const auto place = clipped_at(samples)) {
      refuse(fmt::format("channel {} is clipped at {:.4g} s: it was recorded too loud. Record it again", channel + 1,
                         static_cast<double>(*place) / file.rate));
    }
  }
}

/// When a sound begins, s: where a channel first exceeds a twentieth of its peak, and the noise at its end.
double onset_of(const spectra::SoundFile& file) {
  std::size_t first = file.channels.front().size();
  for (const std::vector<double>& samples : file.channels) {
    const std::size_t tail = samples.size() / 10 + 1;
    double power = 0.0;
    for (const double sample : std::span(samples).last(tail)) {
      power += sample * sample / static_cast<double>(tail);
    }
    const double limit = std::min(std::max(0.05 * largest(samples), 6.0 * std::sqrt(power)), 0.5 * largest(samples));
    const auto above = std::ranges::find_if(samples, [&](double sample) { return std::abs(sample) > limit; });
    first = std::min(first, static_cast<std::size_t>(above - samples.begin()));
  }
  return static_cast<double>(first) / file.rate;
}

/// Reads one recording and appends the part of it that is analysed.
void append(Recordings& all, const MeasuredBody& body, const RecordedBlow& blow, std::span<const double> delays) {
  const spectra::SoundFile file = spectra::read_sound_file(blow.sound);
  const auto refuse = [&](const std::string& problem) {
    throw DeckError(blow.sound_where, fmt::format("{}: {}", blow.sound.string(), problem));
  };
  if (file.channels.size() != delays.size()) {
    refuse(fmt::format("has {} channels, but the deck's listeners are {} microphones", file.channels.size(),
                       delays.size()));
  }
  if (all.rate != 0.0 && file.rate != all.rate) {
    refuse(fmt::format("has {} samples per second, the recordings before it have {}: convert them to one rate",
                       file.rate, all.rate));
  }
  all.rate = file.rate;
  check_samples(file, blow);
  const double time = blow.time.value_or(onset_of(file) - std::ranges::min(delays));
  const double begin = std::max(0.0, time + std::ranges::max(delays) + blow.force_duration() + clearance);
  const auto first = static_cast<std::size_t>(std::ceil(begin * file.rate));
  const std::size_t samples = file.channels.front().size();
  if (first >= samples || static_cast<double>(samples - first) < shortest * file.rate) {
    refuse(fmt::format("less than {} s are left after the end of the blow, at {:.4g} s", shortest, begin));
  }
  all.start.push_back(static_cast<double>(first) / file.rate - time);
  for (const std::vector<double>& channel : file.channels) {
    const auto length = std::min(samples - first, static_cast<std::size_t>(body.duration * file.rate));
    auto& pressure = all.pressure.back().emplace_back();
    for (const double sample : std::span(channel).subspan(first, length)) {
      pressure.push_back(body.full_scale * sample);
    }
  }
}

}  // namespace

Recordings read_recordings(const MeasuredBody& body, std::span<const double> delays) {
  Recordings all;
  std::size_t length = std::numeric_limits<std::size_t>::max();
  for (const RecordedBlow& blow : body.blows) {
    all.pressure.emplace_back();
    append(all, body, blow, delays);
    length = std::min(length, all.pressure.back().front().size());
  }
  for (auto& microphones : all.pressure) {
    for (std::vector<double>& samples : microphones) {
      samples.resize(length);
    }
  }
  return all;
}

}  // namespace idiophone::measured_maps
