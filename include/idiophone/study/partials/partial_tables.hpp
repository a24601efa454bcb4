#pragma once
// Partials, spectra and spectrograms of sounds as CSV files.

#include <filesystem>
#include <vector>

#include "idiophone/foundation/spectra/listener_sound.hpp"
#include "idiophone/study/partials/partials.hpp"

namespace idiophone::partials {

/// What was found in each channel of a sound.
using PartialsByChannel = std::vector<Partials>;

/// Writes a row for each partial: channel,frequency_Hz,level_dB,decay_time_s; the last is empty where it is unknown.
/// Throws std::system_error if the file cannot be written, as the other functions do.
void write_partials(const std::filesystem::path& path, const spectra::Sound& sound, const PartialsByChannel& found);

/// Writes a row for each frequency of the spectrum (frequency_Hz), with a column in dB for each channel.
void write_spectrum(const std::filesystem::path& path, const spectra::Sound& sound);

/// Writes a row for each time and frequency of the first channel's spectrogram: time_s,frequency_Hz,level_dB.
void write_spectrogram(const std::filesystem::path& path, const spectra::Sound& sound);

}  // namespace idiophone::partials
