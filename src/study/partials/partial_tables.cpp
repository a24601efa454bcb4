#include "idiophone/study/partials/partial_tables.hpp"

#include <fmt/os.h>

#include "idiophone/foundation/spectra/spectrum.hpp"

namespace idiophone::partials {

void write_partials(const std::filesystem::path& path, const spectra::Sound& sound, const PartialsByChannel& found) {
  auto file = fmt::output_file(path.string());
  file.print("channel,frequency_Hz,level_dB,decay_time_s\n");
  for (std::size_t channel = 0; channel < found.size(); ++channel) {
    for (const auto& partial : found[channel].found) {
      file.print("{},{:.9g},{:.6g},{}\n", sound.channels[channel], partial.frequency, partial.level,
                 partial.decay_time ? fmt::format("{:.6g}", *partial.decay_time) : "");
    }
  }
}

void write_spectrum(const std::filesystem::path& path, const spectra::Sound& sound) {
  auto file = fmt::output_file(path.string());
  file.print("frequency_Hz");
  std::vector<spectra::Spectrum> spectra;
  for (std::size_t channel = 0; channel < sound.samples.size(); ++channel) {
    file.print(",{}_dB", sound.channels[channel]);
    spectra.push_back(spectra::spectrum(sound.samples[channel], sound.rate));
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

void write_spectrogram(const std::filesystem::path& path, const spectra::Sound& sound) {
  const spectra::Spectrogram spectrogram = spectra::spectrogram(sound.samples.front(), sound.rate);
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

}  // namespace idiophone::partials
