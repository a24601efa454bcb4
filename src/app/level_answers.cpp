#include "level_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "idiophone/foundation/spectra/spectrum.hpp"

namespace idiophone::app {

namespace {

using Channels = std::vector<std::vector<double>>;

Channels part_of(const spectra::Sound& sound, double start, double duration) {
  Channels part;
  for (const std::vector<double>& samples : sound.samples) {
    const auto count = static_cast<double>(samples.size());
    const double first = std::clamp(start * sound.rate, 0.0, count);
    const double last = std::clamp((start + duration) * sound.rate, first, count);
    part.emplace_back(samples.begin() + std::lround(first), samples.begin() + std::lround(last));
  }
  if (part.empty() || part.front().empty()) {
    throw std::invalid_argument(fmt::format("{}: there is no sound from {} s on", sound.name, start));
  }
  return part;
}

/// 1 for a sound file, whose samples have no unit; otherwise the largest sample, as if that were full scale.
double full_scale_of(const spectra::Sound& sound, const Channels& channels) {
  if (sound.unit.empty()) {
    return 1.0;
  }
  double largest = 0.0;
  for (const std::vector<double>& samples : channels) {
    for (const double sample : samples) {
      largest = std::max(largest, std::abs(sample));
    }
  }
  return largest > 0.0 ? largest : 1.0;
}

std::string text_of(const std::optional<double>& value, const std::string& unit) {
  return value ? fmt::format("{:.1f} {}", *value, unit) : "-";
}

/// None for silence.
std::optional<double> heard(double level) {
  return level > spectra::silence ? std::optional(level) : std::nullopt;
}

nlohmann::json number_or_nothing(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json to_json(const levels::Loudness& loudness, double full_scale) {
  return {{"integrated", number_or_nothing(loudness.integrated)},
          {"range", number_or_nothing(loudness.range)},
          {"true_peak", number_or_nothing(loudness.true_peak)},
          {"full_scale", full_scale}};
}

}  // namespace

LevelAnswer measure_levels(const spectra::Sound& sound, double start, double duration) {
  const Channels channels = part_of(sound, start, duration);
  const bool is_pressure = sound.unit == "Pa";
  LevelAnswer answer{.start = start,
                     .duration = static_cast<double>(channels.front().size()) / sound.rate,
                     .reference = is_pressure ? "20 uPa" : (sound.unit.empty() ? "full scale" : "1 " + sound.unit),
                     .full_scale = full_scale_of(sound, channels)};
  const auto beginning = start > 0.0 ? levels::Beginning::inside : levels::Beginning::silence;
  for (const std::vector<double>& samples : channels) {
    answer.channels.push_back(levels::levels_of(samples, sound.rate, is_pressure ? 20e-6 : 1.0, beginning));
  }
  answer.loudness = levels::loudness_of(channels, sound.rate, answer.full_scale);
  return answer;
}

void print_levels(const spectra::Sound& sound, const LevelAnswer& answer) {
  fmt::print("levels of {} from {:.6g} s to {:.6g} s, dB re {}\n", sound.name, answer.start,
             answer.start + answer.duration, answer.reference);
  fmt::print("{:>20}", "");
  for (const std::string& channel : sound.channels) {
    fmt::print("  {:>12}", channel);
  }
  const auto print_row = [&](const std::string& name, const auto& level_of) {
    fmt::print("\n{:>20}", name);
    for (const levels::Levels& channel : answer.channels) {
      fmt::print("  {:>12}", text_of(heard(level_of(channel)), "dB"));
    }
  };
  print_row("Leq", [](const levels::Levels& channel) { return channel.equivalent; });
  print_row("LAeq", [](const levels::Levels& channel) { return channel.weighted; });
  print_row("LAE", [](const levels::Levels& channel) { return channel.exposure; });
  print_row("peak", [](const levels::Levels& channel) { return channel.peak; });
  for (std::size_t band = 0; band < answer.channels.front().bands.size(); ++band) {
    print_row(fmt::format("{:g} Hz", answer.channels.front().bands[band].nominal),
              [&](const levels::Levels& channel) { return channel.bands[band].level; });
  }
  fmt::print("\nloudness {}, range {}, true peak {}", text_of(answer.loudness.integrated, "LUFS"),
             text_of(answer.loudness.range, "LU"), text_of(answer.loudness.true_peak, "dB"));
  fmt::print("{}\n\n",
             sound.unit.empty() ? "" : fmt::format(", if full scale is {:.4g} {}", answer.full_scale, sound.unit));
}

nlohmann::json to_json(const LevelAnswer& answer, std::size_t channel) {
  const levels::Levels& found = answer.channels[channel];
  nlohmann::json bands = nlohmann::json::array();
  for (const levels::ThirdOctave& band : found.bands) {
    bands.push_back({{"nominal", band.nominal}, {"level", number_or_nothing(heard(band.level))}});
  }
  return {{"start", answer.start},
          {"duration", answer.duration},
          {"reference", answer.reference},
          {"equivalent", number_or_nothing(heard(found.equivalent))},
          {"weighted", number_or_nothing(heard(found.weighted))},
          {"exposure", number_or_nothing(heard(found.exposure))},
          {"peak", number_or_nothing(heard(found.peak))},
          {"third_octaves", bands},
          {"loudness", to_json(answer.loudness, answer.full_scale)}};
}

}  // namespace idiophone::app
