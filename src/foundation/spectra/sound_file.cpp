#include "idiophone/foundation/spectra/sound_file.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <memory>
#include <stdexcept>

namespace idiophone::spectra {

SoundFile read_sound_file(const std::filesystem::path& path) {
  SF_INFO info = {};
  const std::unique_ptr<SNDFILE, decltype(&sf_close)> file(sf_open(path.c_str(), SFM_READ, &info), sf_close);
  if (!file) {
    throw std::runtime_error(fmt::format("can't read the sound file {}: {}", path.string(), sf_strerror(nullptr)));
  }
  const auto channels = static_cast<std::size_t>(info.channels);
  std::vector<double> interleaved(channels * static_cast<std::size_t>(info.frames));
  const sf_count_t frames = sf_readf_double(file.get(), interleaved.data(), info.frames);
  if (frames != info.frames) {
    throw std::runtime_error(fmt::format("can't read the sound file {}: it ends after {} of {} samples", path.string(),
                                         frames, info.frames));
  }
  SoundFile sound;
  sound.rate = info.samplerate;
  sound.channels.resize(channels);
  for (std::size_t i = 0; i < interleaved.size(); ++i) {
    sound.channels[i % channels].push_back(interleaved[i]);
  }
  return sound;
}

}  // namespace idiophone::spectra
