#include "idiophone/foundation/spectra/resampled_sound.hpp"

#include <fmt/format.h>
#include <samplerate.h>
#include <sndfile.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace idiophone::spectra {

namespace {

std::vector<double> converted(const std::vector<double>& samples, double ratio, const std::string& file) {
  std::vector<float> input(samples.begin(), samples.end());
  std::vector<float> output(static_cast<std::size_t>(std::ceil(static_cast<double>(input.size()) * ratio)) + 1);
  SRC_DATA data{};
  data.data_in = input.data();
  data.data_out = output.data();
  data.input_frames = static_cast<long>(input.size());
  data.output_frames = static_cast<long>(output.size());
  data.src_ratio = ratio;
  if (const int error = src_simple(&data, SRC_SINC_BEST_QUALITY, 1); error != 0) {
    throw std::runtime_error(fmt::format("{}: can't be converted to another rate: {}", file, src_strerror(error)));
  }
  return {output.begin(), output.begin() + data.output_frames_gen};
}

}  // namespace

std::vector<double> read_sound_file(const std::filesystem::path& file, int rate) {
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound(sf_open(file.c_str(), SFM_READ, &info), &sf_close);
  if (!sound) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), sf_strerror(nullptr)));
  }
  if (info.channels != 1) {
    throw std::runtime_error(fmt::format("{} has {} channels; one is needed", file.string(), info.channels));
  }
  std::vector<double> samples(info.frames);
  if (sf_read_double(sound.get(), samples.data(), info.frames) != info.frames) {
    throw std::runtime_error(fmt::format("{}: ends early", file.string()));
  }
  for (const double sample : samples) {
    if (!std::isfinite(sample)) {
      throw std::runtime_error(fmt::format("{}: has samples that are not finite", file.string()));
    }
  }
  return info.samplerate == rate ? samples
                                 : converted(samples, static_cast<double>(rate) / info.samplerate, file.string());
}

}  // namespace idiophone::spectra
