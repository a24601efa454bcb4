#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/spectra/wav.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/run/results/sound_reader.hpp"

namespace idiophone::loop {

namespace {

spectra::SampleFormat sample_format(scene::WavFormat format) {
  switch (format) {
    case scene::WavFormat::pcm24:
      return spectra::SampleFormat::pcm24;
    case scene::WavFormat::pcm16:
      return spectra::SampleFormat::pcm16;
    default:
      return spectra::SampleFormat::float32;
  }
}

}  // namespace

void require_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(folder.string() + ": there is no such folder");
  }
  if (std::filesystem::is_directory(file)) {
    throw std::runtime_error(file.string() + ": it is a folder; name a file in it");
  }
}

void require_room_for_wav(const std::filesystem::path& file, double samples) {
  constexpr double most_samples = 0x1p30 - 1024.0;  // of 4 bytes
  if (samples > most_samples) {
    throw std::runtime_error(file.string() + ": more sound than the 4 GB of a WAV file hold; shorten the duration");
  }
  require_folder_of(file);
}

void write_wav(const std::filesystem::path& path, std::span<const double> samples, const WavSettings& settings) {
  double loudest = 0.0;
  for (const double sample : samples) {
    loudest = std::max(loudest, std::abs(sample));
  }
  const double full_scale = settings.full_scale.value_or(loudest > 0 ? loudest : 1.0);
  const std::size_t clipped =
      spectra::write_wav(path, samples, {settings.rate, settings.channels, sample_format(settings.format), full_scale});
  spdlog::info("{}: full scale is {:.4g} {}, the loudest sample {:.4g}", path.string(), full_scale, settings.unit,
               loudest);
  if (std::ranges::all_of(samples, [](double sample) { return sample == 0.0; })) {
    spdlog::warn("{} is silent", path.string());
  }
  if (clipped > 0) {
    spdlog::warn("{}: {} samples exceed full scale{}; raise {}", path.string(), clipped,
                 settings.format == scene::WavFormat::float32 ? "" : " and were clipped", settings.full_scale_key);
  }
}

void write_wavs(const scene::Scene& scene, const std::filesystem::path& directory) {
  const std::vector<spectra::Sound> sounds = results::read_sounds(directory / (scene.name + ".h5"));
  for (const auto& sound : sounds) {
    const std::size_t width = sound.samples.size();
    std::vector<double> samples(width * sound.samples.front().size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i] = sound.samples[i % width][i / width];
    }
    const std::string name = sounds.size() == 1 ? scene.name : scene.name + "_" + sound.name;
    write_wav(directory / (name + ".wav"), samples,
              {.rate = static_cast<int>(sound.rate),
               .channels = static_cast<int>(width),
               .format = scene.output.wav,
               .full_scale = scene.output.wav_full_scale,
               .full_scale_key = "output.wav_full_scale",
               .unit = sound.unit});
  }
}

}  // namespace idiophone::loop
