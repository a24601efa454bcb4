#pragma once
// Outputs that write a file when the performance is over.

#include <filesystem>
#include <functional>
#include <string>

#include "idiophone/foundation/origin.hpp"
#include "idiophone/instruments/outputs/collected.hpp"
#include "idiophone/run/loop/wav_files.hpp"

namespace idiophone::results {
class ResultFile;
}

namespace idiophone::outputs {

/// A WAV file.
class WavOutput : public Collected {
 public:
  /// @throws std::runtime_error when the file can't be written there, or would be too long
  WavOutput(std::filesystem::path file, loop::WavSettings settings, std::int64_t samples);

  void finish() override;

 private:
  std::filesystem::path file_;
  loop::WavSettings settings_;
};

/// A result with the series /audio/NAME, for `info`, `analyze` and `report`.
class ResultOutput : public Collected {
 public:
  /// @param origin  its name is also that of the series
  /// @param unit  of the samples
  /// @param more  writes what else belongs into the result, when it has the sound; nothing if empty
  /// @throws std::runtime_error when the file can't be written there
  ResultOutput(std::filesystem::path file, Origin origin, std::string unit, int rate, std::int64_t samples,
               std::function<void(results::ResultFile&)> more = {});

  void finish() override;

 private:
  std::filesystem::path file_;
  Origin origin_;
  std::string unit_;
  int rate_;
  std::function<void(results::ResultFile&)> more_;
};

}  // namespace idiophone::outputs
