#include "idiophone/instruments/outputs/audio_output.hpp"

#include <fmt/format.h>
#include <portaudio.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "idiophone/instruments/outputs/quiet_audio.hpp"

namespace idiophone::outputs {

namespace {

using Clock = std::chrono::steady_clock;

/// "API: NAME"
std::string name_of(PaDeviceIndex device) {
  const PaDeviceInfo& info = *Pa_GetDeviceInfo(device);
  return fmt::format("{}: {}", Pa_GetHostApiInfo(info.hostApi)->name, info.name);
}

/// @param wanted  part of a name; empty for the default
PaDeviceIndex find_device(const std::string& wanted) {
  std::string names;
  for (PaDeviceIndex device = 0; device < Pa_GetDeviceCount(); ++device) {
    if (Pa_GetDeviceInfo(device)->maxOutputChannels == 0) {
      continue;
    }
    names += "\n  " + name_of(device);
    if (!wanted.empty() && name_of(device).find(wanted) != std::string::npos) {
      return device;
    }
  }
  if (names.empty()) {
    throw std::runtime_error("there is no audio device for output; start a JACK server, or write a file with --output");
  }
  if (wanted.empty() && Pa_GetDefaultOutputDevice() != paNoDevice) {
    return Pa_GetDefaultOutputDevice();
  }
  throw std::runtime_error(wanted.empty() ? "there is no default audio device; choose one with --device:" + names
                                          : fmt::format("there is no audio device '{}'; there are:{}", wanted, names));
}

}  // namespace

struct AudioOutput::Stream {
  /// PortAudio, from start to end of the program's use of it.
  struct Session {
    Session() {
      silence_audio_libraries();
      if (const PaError error = Pa_Initialize(); error != paNoError) {
        throw std::runtime_error(fmt::format("audio: {}", Pa_GetErrorText(error)));
      }
    }
    ~Session() {
      if (!lost) {
        Pa_Terminate();
      }
    }
    Session(const Session&) = delete;
    Session(Session&&) = delete;
    Session& operator=(const Session&) = delete;
    Session& operator=(Session&&) = delete;

    bool lost = false;  ///< the device is gone: PortAudio would wait for it for ever
  };

  Session session;
  Renderer* renderer = nullptr;
  std::size_t receivers = 1;
  int rate = 48000;
  AudioOptions options;
  std::string device;
  PaStream* stream = nullptr;
  std::vector<double> block;  // [frames x receivers]
  // written by the audio thread
  std::atomic<std::int64_t> blocks{0}, late{0}, clipped{0}, busy{0};  // busy: ns
  std::atomic<double> largest_load{0.0};

  static int call_back(const void* /*input*/, void* output, unsigned long frames,
                       const PaStreamCallbackTimeInfo* /*time*/, PaStreamCallbackFlags flags, void* self) {
    static_cast<Stream*>(self)->render(static_cast<float*>(output), frames, (flags & paOutputUnderflow) != 0);
    return paContinue;
  }

  void render(float* output, unsigned long frames, bool missed) {
    const Clock::time_point begin = Clock::now();
    std::int64_t beyond = 0;
    for (unsigned long first = 0; first < frames; first += options.frames) {  // more than asked for is possible
      const std::size_t count = std::min(options.frames, frames - first) * receivers;
      renderer->render(std::span(block).first(count), begin.time_since_epoch().count());
      for (std::size_t i = 0; i < count; ++i) {
        const double sample = block[i] / options.full_scale;
        beyond += std::abs(sample) > 1.0 ? 1 : 0;
        output[first * receivers + i] = static_cast<float>(std::clamp(sample, -1.0, 1.0));
      }
    }
    const auto taken = std::chrono::nanoseconds(Clock::now() - begin).count();
    const double load = 1e-9 * static_cast<double>(taken) * rate / static_cast<double>(frames);
    ++blocks;
    late += missed || load > 1.0 ? 1 : 0;
    clipped += beyond;
    busy += taken;
    largest_load = std::max(largest_load.load(), load);
  }

  void open() {
    const PaDeviceIndex index = find_device(options.device);
    device = name_of(index);
    const PaStreamParameters parameters{.device = index,
                                        .channelCount = static_cast<int>(receivers),
                                        .sampleFormat = paFloat32,
                                        .suggestedLatency = Pa_GetDeviceInfo(index)->defaultLowOutputLatency,
                                        .hostApiSpecificStreamInfo = nullptr};
    PaError error = Pa_OpenStream(&stream, nullptr, &parameters, rate, options.frames, paNoFlag, &call_back, this);
    if (error == paNoError) {
      error = Pa_StartStream(stream);
    }
    if (error != paNoError) {
      if (stream != nullptr) {
        Pa_CloseStream(stream);
      }
      throw std::runtime_error(
          fmt::format("{}: {} channels at {} Hz can't be played: {}", device, receivers, rate, Pa_GetErrorText(error)));
    }
  }
};

AudioOutput::AudioOutput(Renderer& renderer, const AudioOptions& options) : stream_(std::make_unique<Stream>()) {
  stream_->renderer = &renderer;
  stream_->receivers = renderer.receivers();
  stream_->rate = renderer.rate();
  stream_->options = options;
  stream_->block.resize(options.frames * renderer.receivers());
  stream_->open();
}

AudioOutput::~AudioOutput() {
  stream_->session.lost = Pa_IsStreamActive(stream_->stream) != 1;
  if (!stream_->session.lost) {
    Pa_AbortStream(stream_->stream);
    Pa_CloseStream(stream_->stream);
  }
}

const std::string& AudioOutput::device() const {
  return stream_->device;
}

AudioReport AudioOutput::report() const {
  AudioReport report{.blocks = stream_->blocks,
                     .late = stream_->late,
                     .largest_load = stream_->largest_load,
                     .clipped = stream_->clipped,
                     .output_latency = Pa_GetStreamInfo(stream_->stream)->outputLatency,
                     .running = Pa_IsStreamActive(stream_->stream) == 1};
  const double played = static_cast<double>(stream_->renderer->now()) / stream_->rate;
  report.mean_load = played > 0.0 ? 1e-9 * static_cast<double>(stream_->busy) / played : 0.0;
  return report;
}

}  // namespace idiophone::outputs
