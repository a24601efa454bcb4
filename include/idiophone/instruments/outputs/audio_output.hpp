#pragma once
// From a renderer to an audio device, through PortAudio: ALSA or JACK.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "idiophone/instruments/outputs/output.hpp"

namespace idiophone::outputs {

struct AudioOptions {
  std::string device;        ///< part of "API: NAME"; empty for the default device
  std::size_t frames = 128;  ///< of a block
  double full_scale = 1.0;   ///< pressure that becomes the loudest sample, Pa
};

/// What happened so far.
struct AudioReport {
  std::int64_t blocks = 0;
  std::int64_t late = 0;        ///< blocks that took longer than they last, or that the device reports as missed
  double mean_load = 0.0;       ///< computing time of a block over its duration
  double largest_load = 0.0;    ///< likewise
  std::int64_t clipped = 0;     ///< samples beyond full scale
  double output_latency = 0.0;  ///< s, as the device states it
  bool running = true;          ///< false if the device or its server is gone
};

class AudioOutput {
 public:
  /// Opens the device and starts it. It renders from now on in the thread of the device.
  /// @throws std::runtime_error when there is no such device, or it refuses rate or channels
  AudioOutput(Renderer& renderer, const AudioOptions& options);
  ~AudioOutput();
  AudioOutput(const AudioOutput&) = delete;
  AudioOutput(AudioOutput&&) = delete;
  AudioOutput& operator=(const AudioOutput&) = delete;
  AudioOutput& operator=(AudioOutput&&) = delete;

  [[nodiscard]] const std::string& device() const;
  [[nodiscard]] AudioReport report() const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

/// The device as the output of a performance.
class DeviceOutput : public Output {
 public:
  /// @param what  is played, in words, for the log
  DeviceOutput(AudioOptions options, std::string what, int rate);

  [[nodiscard]] std::int64_t horizon() const override;
  void start(Renderer& renderer) override;
  bool advance() override;
  /// Logs what happened. @throws std::runtime_error when the device or its server stopped
  void finish() override;

 private:
  AudioOptions options_;
  std::string what_;
  int rate_;
  std::optional<AudioOutput> audio_;
};

}  // namespace idiophone::outputs
