#include <fmt/format.h>
#include <fmt/os.h>

#include <stdexcept>

#include "commands.hpp"
#include "idiophone/analysis/compare.hpp"
#include "idiophone/analysis/spectrum.hpp"
#include "idiophone/store/sound_reader.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

/// All references in one list, each with the name of its set where there are several.
void print_partials(const store::Sound& sound, const std::vector<store::ReferenceFrequencies>& references,
                    const AnalyzeOptions& options) {
  analysis::PartialOptions wanted;
  wanted.start = options.start;
  wanted.duration = options.duration;
  wanted.lowest = options.lowest;
  wanted.highest = options.highest;
  wanted.dynamic_range = options.dynamic_range;
  for (std::size_t channel = 0; channel < sound.samples.size(); ++channel) {
    const auto partials = analysis::find_partials(sound.samples[channel], sound.rate, wanted);
    fmt::print("{} (level in dB re 1 {} at {} s)\n", sound.channels[channel], sound.unit, options.start);
    if (references.empty()) {
      fmt::print("{}\n", analysis::table(partials, {}, options.tolerance));
    }
    for (const auto& reference : references) {
      fmt::print("{}\n", analysis::table(partials, {reference.name, reference.frequencies}, options.tolerance));
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
    print_partials(sound, references, options);
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
