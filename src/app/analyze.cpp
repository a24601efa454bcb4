#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <stdexcept>

#include "commands.hpp"
#include "idiophone/analysis/compare.hpp"
#include "idiophone/analysis/spectrum.hpp"
#include "idiophone/store/sound_reader.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

/// Where the analysis begins, s: after the blow.
double start_of(const store::Sound& sound, const AnalyzeOptions& options) {
  const double length = static_cast<double>(sound.samples.front().size()) / sound.rate;
  return options.start.value_or(std::min(0.02, length / 10));
}

using PartialsByChannel = std::vector<std::vector<analysis::Partial>>;

PartialsByChannel find_partials(const store::Sound& sound, const AnalyzeOptions& options) {
  analysis::PartialOptions wanted;
  wanted.start = start_of(sound, options);
  wanted.duration = options.duration;
  wanted.lowest = options.lowest;
  wanted.highest = options.highest;
  wanted.dynamic_range = options.dynamic_range;
  PartialsByChannel partials;
  for (const auto& samples : sound.samples) {
    partials.push_back(analysis::find_partials(samples, sound.rate, wanted));
  }
  return partials;
}

/// A table for each set of references, one after the other.
void print_partials(const store::Sound& sound, const PartialsByChannel& partials,
                    const std::vector<store::ReferenceFrequencies>& references, const AnalyzeOptions& options) {
  for (std::size_t channel = 0; channel < partials.size(); ++channel) {
    fmt::print("{} (level in dB re 1 {} at {} s)\n", sound.channels[channel], sound.unit, start_of(sound, options));
    if (references.empty()) {
      fmt::print("{}\n", analysis::table(partials[channel], {}, options.tolerance));
    }
    for (const auto& reference : references) {
      fmt::print("{}\n",
                 analysis::table(partials[channel], {reference.name, reference.frequencies}, options.tolerance));
    }
  }
}

void write_partials(const std::filesystem::path& path, const store::Sound& sound, const PartialsByChannel& partials) {
  auto file = fmt::output_file(path.string());
  file.print("channel,frequency_Hz,level_dB,decay_time_s\n");
  for (std::size_t channel = 0; channel < partials.size(); ++channel) {
    for (const auto& partial : partials[channel]) {
      file.print("{},{:.9g},{:.6g},{}\n", sound.channels[channel], partial.frequency, partial.level,
                 partial.decay_time ? fmt::format("{:.6g}", *partial.decay_time) : "");
    }
  }
}

void write_spectrum(const std::filesystem::path& path, const store::Sound& sound) {
  auto file = fmt::output_file(path.string());
  file.print("frequency_Hz");
  std::vector<analysis::Spectrum> spectra;
  for (std::size_t channel = 0; channel < sound.samples.size(); ++channel) {
    file.print(",{}_dB", sound.channels[channel]);
    spectra.push_back(analysis::spectrum(sound.samples[channel], sound.rate));
  }
  file.print("\n");
  for (std::size_t bin = 0; bin < spectra.front().level.size(); ++bin) {
    file.print("{:.6g}", static_cast<double>(bin) * spectra.front().frequency_step);
    for (const auto& spectrum : spectra) {
      file.print(",{:.6g}", spectrum.level[bin]);
    }
    file.print("\n");
  }
}

void write_spectrogram(const std::filesystem::path& path, const store::Sound& sound) {
  const analysis::Spectrogram spectrogram = analysis::spectrogram(sound.samples.front(), sound.rate);
  auto file = fmt::output_file(path.string());
  file.print("time_s,frequency_Hz,level_dB\n");
  for (std::size_t block = 0; block < spectrogram.blocks; ++block) {
    for (std::size_t bin = 0; bin < spectrogram.bins; ++bin) {
      file.print("{:.6g},{:.6g},{:.6g}\n", spectrogram.first_time + static_cast<double>(block) * spectrogram.time_step,
                 static_cast<double>(bin) * spectrogram.frequency_step,
                 spectrogram.level[block * spectrogram.bins + bin]);
    }
  }
}

}  // namespace

int analyze(const AnalyzeOptions& options) {
  const auto references = store::read_references(options.result);
  bool found = false;
  for (const store::Sound& sound : store::read_sounds(options.result)) {
    if (!options.listener.empty() && options.listener != sound.name) {
      continue;
    }
    const PartialsByChannel partials = find_partials(sound, options);
    print_partials(sound, partials, references, options);
    if (!found && !options.partials.empty()) {
      write_partials(options.partials, sound, partials);
    }
    if (!found && !options.spectrum.empty()) {
      write_spectrum(options.spectrum, sound);
    }
    if (!found && !options.spectrogram.empty()) {
      write_spectrogram(options.spectrogram, sound);
    }
    found = true;
  }
  if (!found) {
    throw std::runtime_error(fmt::format("{} has no listener '{}'", options.result.string(), options.listener));
  }
  return exit_finished;
}

}  // namespace idiophone::app
