#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "idiophone/listening/wav.hpp"
#include "idiophone/store/sound_reader.hpp"
#include "wav_files.hpp"

namespace idiophone::app {

namespace {

listening::SampleFormat sample_format(scene::WavFormat format) {
  switch (format) {
    case scene::WavFormat::pcm24:
      return listening::SampleFormat::pcm24;
    case scene::WavFormat::pcm16:
      return listening::SampleFormat::pcm16;
    default:
      return listening::SampleFormat::float32;
  }
}

}  // namespace

void write_wavs(const scene::Scene& scene, const std::filesystem::path& directory) {
  const std::vector<store::Sound> sounds = store::read_sounds(directory / (scene.name + ".h5"));
  for (const auto& sound : sounds) {
    const std::size_t width = sound.samples.size();
    std::vector<double> samples(width * sound.samples.front().size());
    double loudest = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i] = sound.samples[i % width][i / width];
      loudest = std::max(loudest, std::abs(samples[i]));
    }
    const double full_scale = scene.output.wav_full_scale.value_or(loudest > 0 ? loudest : 1.0);
    const std::string name = sounds.size() == 1 ? scene.name : scene.name + "_" + sound.name;
    const auto path = directory / (name + ".wav");
    const std::size_t clipped = listening::write_wav(
        path, samples, {scene.audio.rate, static_cast<int>(width), sample_format(scene.output.wav), full_scale});
    spdlog::info("{}: full scale is {:.4g} {}, the loudest sample {:.4g}", path.string(), full_scale, sound.unit,
                 loudest);
    if (clipped > 0) {
      spdlog::warn("{}: {} samples exceed full scale{}; raise output.wav_full_scale", path.string(), clipped,
                   scene.output.wav == scene::WavFormat::float32 ? "" : " and were clipped");
    }
  }
}

}  // namespace idiophone::app
