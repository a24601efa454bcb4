#pragma once
// A voice that is computed ahead by a thread of its own (O'Morain 2005, sections 5.3 and 5.4), so that it may allocate
// and take its time. The audio thread only takes what is ready.

#include <memory>
#include <mutex>
#include <optional>

#include "idiophone/instruments/outputs/buffered_renderer.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::voices {

/// How far it is computed ahead.
struct Buffering {
  std::size_t frames = 256;  ///< audio samples in a buffer
  std::size_t buffers = 8;   ///< at least 2
};

class BufferedVoice : public Voice {
 public:
  BufferedVoice(std::unique_ptr<Voice> voice, std::size_t channels, int rate, const Buffering& buffering);

  [[nodiscard]] const std::vector<std::string>& bodies() const override { return voice_->bodies(); }
  [[nodiscard]] std::optional<Vector3> centre(std::size_t body) const override;
  void require_tunable(std::size_t body, const score::Tuning& tuning) const override;
  void require_in_reach(const Vector3& place) const override;
  void excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) override;
  void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) override;
  void set_detail(std::size_t body, const score::Detail& detail, std::int64_t start) override;
  void set_budget(double budget, std::int64_t start) override;
  void hear_at(const ListenerPlace& place) override;
  void attend() override;
  [[nodiscard]] std::int64_t lead() const override;
  void begin() override;
  void end() override { ahead_.reset(); }
  [[nodiscard]] VoiceReport report() const override;
  void render(std::span<double> sound, std::int64_t clock) override;

 private:
  void fill(std::span<double> sound);

  std::unique_ptr<Voice> voice_;
  std::size_t channels_;
  int rate_;
  Buffering buffering_;
  mutable std::mutex mutex_;  // of the voice; the audio thread does not touch it
  std::vector<double> ready_;
  bool failed_ = false;                             // of the filling thread
  std::optional<outputs::BufferedRenderer> ahead_;  // its thread ends first
};

}  // namespace idiophone::voices
