// Sound files, MIDI files and head-related responses, which libraries read for us.

#include <cmath>
#include <stdexcept>

#include "fixture.hpp"
#include "head_reader.hpp"
#include "idiophone/foundation/spectra/sound_file.hpp"
#include "idiophone/foundation/spectra/wav.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/study/fitting/measurements.hpp"
#include "idiophone/timbre/evolution/evolution.hpp"

namespace idiophone::mutants {

namespace {

using Sounds = Mutants;
using File = std::filesystem::path;

/// A decaying tone in each format of our WAV files.
std::vector<File> tones(const File& folder) {
  std::vector<double> samples(4000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time = static_cast<double>(i) / 8000;
    samples[i] = std::exp(-6 * time) * std::sin(2800 * time);
  }
  std::vector<File> files;
  for (const auto format :
       {spectra::SampleFormat::float32, spectra::SampleFormat::pcm24, spectra::SampleFormat::pcm16}) {
    files.push_back(folder / fmt::format("tone_{}.wav", files.size()));
    spectra::write_wav(files.back(), samples, {.rate = 8000, .format = format});
  }
  return files;
}

TEST_F(Sounds, Wav) {
  expect_answers({.type = "wav",
                  .originals = tones(folder),
                  .mutate = mutate_bytes,
                  .read =
                      [](const File& file) {
                        static_cast<void>(timbre::read_target(file, 44100));
                        for (const auto& line : fitting::read_measurements(file).lines) {
                          if (!std::isfinite(line.frequency)) {
                            throw std::logic_error("a frequency is not finite");
                          }
                        }
                      },
                  .share = 4});
}

TEST_F(Sounds, Midi) {
  using namespace std::string_literals;
  const std::string track =
      "\x00\xff\x51\x03\x0f\x42\x40\x00\x90\x3c\x40\x60\x80\x3c\x00\x30\x90\x40\x7f\x00\x90\x3c\x00\x00\xff\x2f\x00"s;
  const std::string head = "MThd\x00\x00\x00\x06\x00\x00\x00\x01\x00\x60MTrk\x00\x00\x00"s;
  expect_answers({.type = "midi",
                  .originals = {made("notes.mid", head + static_cast<char>(track.size()) + track)},
                  .mutate = mutate_bytes,
                  .read = [](const File& file) { static_cast<void>(drivers::read_midi_file(file)); }});
}

TEST_F(Sounds, HeadResponses) {
  const File original = folder / "head.sofa";
  std::filesystem::copy_file("/usr/share/libmysofa/MIT_KEMAR_normal_pinna.sofa", original);
  expect_answers({.type = "sofa", .originals = {original}, .mutate = mutate_bytes, .read = read_head, .share = 4});
}

}  // namespace

}  // namespace idiophone::mutants
