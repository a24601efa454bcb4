#pragma once
// Recordings of struck bodies for tests: damped sines and noise in sound files.

#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <vector>

namespace idiophone::fitting {

struct DampedSine {
  double frequency = 0.0;   ///< Hz
  double decay_time = 1.0;  ///< T60, s
  double amplitude = 0.3;
};

/// A tenth of a second of silence, then all sines, and noise all the time.
/// @param noise  root mean square
inline std::vector<double> struck(const std::vector<DampedSine>& sines, int rate, double duration, double noise = 0.0) {
  std::mt19937 generator(17);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<double> samples(std::lround(rate * duration));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / rate - 0.1;
    samples[i] = noise * normal(generator);
    for (const auto& [frequency, decay_time, amplitude] : sines) {
      samples[i] += t < 0 ? 0.0
                          : amplitude * std::exp(-t * std::log(1000.0) / decay_time) *
                                std::sin(2 * std::numbers::pi * frequency * t);
    }
  }
  return samples;
}

/// Writes channels of one length.
/// @param format  of libsndfile
/// @return the file's path
inline std::filesystem::path write_recording(const std::string& name, int rate,
                                             const std::vector<std::vector<double>>& channels,
                                             int format = SF_FORMAT_WAV | SF_FORMAT_FLOAT) {
  auto path = std::filesystem::path(::testing::TempDir()) / name;
  SF_INFO info = {};
  info.samplerate = rate;
  info.channels = static_cast<int>(channels.size());
  info.format = format;
  std::vector<double> frames;
  for (std::size_t i = 0; i < channels.front().size(); ++i) {
    for (const std::vector<double>& channel : channels) {
      frames.push_back(channel[i]);
    }
  }
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  sf_writef_double(file, frames.data(), static_cast<sf_count_t>(channels.front().size()));
  sf_close(file);
  return path;
}

}  // namespace idiophone::fitting
