#include "idiophone/foundation/spectra/wav.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace idiophone::spectra {

namespace {

int encoding(SampleFormat format) {
  switch (format) {
    case SampleFormat::float32:
      return SF_FORMAT_FLOAT;
    case SampleFormat::pcm24:
      return SF_FORMAT_PCM_24;
    case SampleFormat::pcm16:
      return SF_FORMAT_PCM_16;
  }
  throw std::invalid_argument("WAV: unknown sample format");
}

void validate(const std::string& path, std::span<const double> samples, const WavOptions& options) {
  const auto require = [&](bool condition, const std::string& what) {
    if (!condition) {
      throw std::invalid_argument(fmt::format("{}: {}", path, what));
    }
  };
  require(options.rate >= 1 && options.channels >= 1, "rate and channels must be positive");
  require(options.full_scale > 0.0 && std::isfinite(options.full_scale),
          fmt::format("full scale is {}; it must be positive and finite", options.full_scale));
  require(samples.size() % static_cast<std::size_t>(options.channels) == 0,
          fmt::format("{} samples are not a whole number of frames of {} channels", samples.size(), options.channels));
  const auto bad = std::ranges::find_if_not(samples, [](double sample) { return std::isfinite(sample); });
  require(bad == samples.end(), fmt::format("sample {} is not finite", bad - samples.begin()));
  require(samples.size() < (1UL << 30U) - 1024, "the sound exceeds the 4 GB of a WAV file; use the HDF5 result");
}

void write(const std::string& path, std::span<const double> samples, const WavOptions& options) {
  SF_INFO info{};
  info.samplerate = options.rate;
  info.channels = options.channels;
  info.format = SF_FORMAT_WAV | encoding(options.format);
  std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> file(sf_open(path.c_str(), SFM_WRITE, &info), &sf_close);
  if (!file) {
    throw std::runtime_error(fmt::format("{}: can't be written: {}", path, sf_strerror(nullptr)));
  }
  sf_command(file.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it contains the time of writing
  const auto count = static_cast<sf_count_t>(samples.size());
  if (sf_write_double(file.get(), samples.data(), count) != count || sf_error(file.get()) != SF_ERR_NO_ERROR) {
    throw std::runtime_error(fmt::format("{}: writing failed: {}", path, sf_strerror(file.get())));
  }
  sf_write_sync(file.get());
  if (const int error = sf_close(file.release()); error != SF_ERR_NO_ERROR) {
    throw std::runtime_error(fmt::format("{}: writing failed: {}", path, sf_error_number(error)));
  }
}

}  // namespace

std::size_t write_wav(const std::filesystem::path& path, std::span<const double> samples, const WavOptions& options) {
  validate(path.string(), samples, options);
  std::vector<double> scaled(samples.begin(), samples.end());
  std::size_t exceeding = 0;
  for (double& sample : scaled) {
    sample /= options.full_scale;
    if (std::abs(sample) > std::numeric_limits<float>::max()) {
      throw std::invalid_argument(
          fmt::format("{}: with a full scale of {} samples are too large for a WAV file; raise it", path.string(),
                      options.full_scale));
    }
    exceeding += std::abs(sample) > 1.0 ? 1 : 0;
    if (options.format != SampleFormat::float32) {
      sample = std::clamp(sample, -1.0, 1.0);
    }
  }
  const std::filesystem::path part = path.string() + ".part";
  try {
    write(part.string(), scaled, options);
    std::filesystem::rename(part, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
  return exceeding;
}

}  // namespace idiophone::spectra
