#pragma once
// A ring of audio buffers between two threads: one computes ahead and fills them, the audio thread plays them (O'Morain
// 2005, sections 5.3 and 5.4).

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

#include "idiophone/instruments/outputs/renderer.hpp"

namespace idiophone::outputs {

class BufferedRenderer : public Renderer {
 public:
  /// Computes the next samples, in a thread of its own.
  using Fill = std::function<void(std::span<double> sound)>;

  /// Fills all buffers, then goes on in a thread.
  /// @param frames   audio samples in a buffer
  /// @param buffers  at least 2
  BufferedRenderer(Fill fill, int rate, std::size_t frames, std::size_t buffers, std::size_t channels = 1);
  ~BufferedRenderer() override;
  BufferedRenderer(const BufferedRenderer&) = delete;
  BufferedRenderer(BufferedRenderer&&) = delete;
  BufferedRenderer& operator=(const BufferedRenderer&) = delete;
  BufferedRenderer& operator=(BufferedRenderer&&) = delete;

  [[nodiscard]] int rate() const override { return rate_; }
  [[nodiscard]] std::size_t receivers() const override { return channels_; }
  void render(std::span<double> sound, std::int64_t clock) override;
  [[nodiscard]] std::int64_t now() const override { return now_; }

  /// Times when the audio thread found no full buffer: silence was played.
  [[nodiscard]] std::int64_t gaps() const { return gaps_; }

 private:
  void fill_all();
  void fill_next();

  Fill fill_;
  int rate_;
  std::size_t channels_;
  std::vector<std::vector<double>> buffers_;
  std::atomic<std::size_t> filled_{0}, played_{0};  // buffers so far
  std::atomic<std::int64_t> now_{0}, gaps_{0};
  std::atomic<bool> ends_{false};
  std::size_t place_ = 0;  // audio thread: samples of the present buffer that were played
  std::thread thread_;
};

}  // namespace idiophone::outputs
