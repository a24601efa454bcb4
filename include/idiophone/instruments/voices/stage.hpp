#pragma once
// Bodies that are played together: what drivers ask for goes to the voices, and their sounds are added up.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/driver.hpp"
#include "idiophone/instruments/drivers/few_warnings.hpp"
#include "idiophone/instruments/outputs/output.hpp"
#include "idiophone/instruments/voices/voice.hpp"

namespace idiophone::voices {

class Stage : public outputs::Renderer {
 public:
  /// @param voices    at least one
  /// @param channels  of the sound that they all render
  Stage(Audience audience, std::vector<std::unique_ptr<Voice>> voices, std::size_t channels, int rate);

  /// Of all voices, in their order. Events have their numbers.
  [[nodiscard]] const std::vector<std::string>& bodies() const { return bodies_; }
  /// Voice::centre().
  [[nodiscard]] std::optional<Vector3> centre(std::size_t body) const;
  /// The longest Voice::lead().
  [[nodiscard]] std::int64_t lead() const { return lead_; }
  /// @throws as Voice::require_tunable()
  void require_tunable(std::size_t body, const score::Tuning& tuning) const;
  /// @throws as Voice::require_touchable()
  void require_touchable(std::size_t body) const;

  // The control thread's part.

  /// Asks the drivers for what happens before an audio sample, and does it. What a player asked for and can't be done
  /// is logged.
  /// @throws std::exception for what was known before and can't be done
  void drive(const drivers::Drivers& drivers, std::int64_t until);

  /// Does something. @throws std::exception when it can't be done
  void perform(const drivers::Event& event);

  /// Once, before the first sample is rendered and after the first drive().
  void begin();

  /// Once, after the last sample.
  void end();

  /// Of all voices.
  [[nodiscard]] VoiceReport report() const;

  // The audio thread's part.

  void render(std::span<double> sound, std::int64_t clock) override;

  // Of both.

  [[nodiscard]] int rate() const override { return rate_; }
  [[nodiscard]] std::size_t receivers() const override { return channels_; }
  [[nodiscard]] std::int64_t now() const override { return now_.load(std::memory_order_acquire); }

 private:
  /// A body of a voice.
  struct Place {
    Voice* voice;
    std::size_t body;
  };
  void move_listener(const Vector3& position);
  void follow_path(std::int64_t until);
  void go_where_wanted();
  void hear_at(ListenerPlace place);

  Audience audience_;
  std::vector<std::unique_ptr<Voice>> voices_;
  std::size_t channels_;
  int rate_;
  std::vector<std::string> bodies_;
  std::vector<Place> places_;      // [bodies]
  std::int64_t lead_ = 0;          // the longest of the voices'
  std::int64_t change_end_ = 0;    // audio sample at which the listener is where it was sent
  std::optional<Vector3> wanted_;  // where the listener goes next, m
  std::vector<drivers::Event> events_;
  drivers::FewWarnings left_out_;  // of what players asked for
  std::atomic<std::int64_t> now_{0};
};

/// The loop of every performance, live and to a file: drivers ask, voices sound, the output hears. It ends after a
/// number of audio samples; if a driver is live, only when it is interrupted; or when the output is gone.
/// @param interrupted  whether a signal came
void perform(Stage& stage, const drivers::Drivers& drivers, outputs::Output& output, std::int64_t samples,
             const std::function<bool()>& interrupted);

/// The next samples, Pa, [samples x receivers].
/// @param block  audio samples that are rendered at once
[[nodiscard]] std::vector<double> rendered(Stage& stage, const drivers::Drivers& drivers, std::int64_t samples,
                                           std::int64_t block = 512);

}  // namespace idiophone::voices
