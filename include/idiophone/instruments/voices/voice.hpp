#pragma once
// A voice: a body that forces excite and that is heard, or several bodies that are computed together. Two threads use
// it. The control thread asks, the audio thread renders.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/event.hpp"
#include "idiophone/instruments/voices/audience.hpp"

namespace idiophone::voices {

inline constexpr double longest_way = 1.0;  ///< s, of sound from a body to a listener

/// Times from when a player asked for a blow to the audio sample at which it began. Strokes do not count.
struct Waits {
  std::int64_t count = 0;
  double mean = 0.0;     ///< s
  double longest = 0.0;  ///< s

  /// Those of others, too.
  void add(const Waits& others);
};

/// What happened so far.
struct VoiceReport {
  Waits waits;
  std::int64_t gaps = 0;              ///< times when the audio thread had to play silence
  std::vector<std::string> doubts{};  ///< what was beyond the limits of a model, for warnings
};

class Voice {
 public:
  Voice() = default;
  virtual ~Voice() = default;
  Voice(const Voice&) = delete;
  Voice(Voice&&) = delete;
  Voice& operator=(const Voice&) = delete;
  Voice& operator=(Voice&&) = delete;

  /// Their names. The functions below take their numbers.
  [[nodiscard]] virtual const std::vector<std::string>& bodies() const = 0;

  // The control thread's part.

  /// Centre of mass in the coordinates of the forces, m; none for a sound without a shape.
  [[nodiscard]] virtual std::optional<Vector3> centre(std::size_t body) const = 0;

  /// @throws std::runtime_error when a body can't be tuned so, or not at all
  virtual void require_tunable(std::size_t body, const score::Tuning& tuning) const = 0;

  /// @throws std::runtime_error when a listener there is too far away to be heard by
  virtual void require_in_reach(const Vector3& /*place*/) const {}

  /// Forces begin at their starts, or at once if those are over.
  /// @param sent  as in drivers::Event
  /// @throws std::runtime_error when a player asks for more than can be done at once
  virtual void excite(std::size_t body, const drivers::Excitation& excitation, std::int64_t sent) = 0;

  /// @param start  audio sample
  virtual void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) = 0;

  /// @throws std::runtime_error when a body does not feel contacts; touch() and lead() are not called then
  virtual void require_touchable(std::size_t body) const;

  /// @param start  audio sample
  /// @throws std::runtime_error when too many contacts act on the body
  virtual void touch(std::size_t /*body*/, const drivers::Touching& /*touch*/, std::int64_t /*start*/) {}
  virtual void lead(std::size_t /*body*/, const drivers::TouchLead& /*lead*/, std::int64_t /*start*/) {}

  /// @param start  audio sample
  /// @throws std::runtime_error when a body has no levels of detail, or not this one
  virtual void set_detail(std::size_t body, const score::Detail& detail, std::int64_t start);

  /// Of all voices that have levels of detail together.
  /// @param budget  processor time per time of sound
  /// @param start   audio sample
  virtual void set_budget(double /*budget*/, std::int64_t /*start*/) {}

  /// In the order of their starts.
  virtual void hear_at(const ListenerPlace& place) = 0;

  /// Called often: hands on what there was no room for, and frees what is done.
  virtual void attend() {}

  /// Audio samples by which it must know ahead what begins.
  [[nodiscard]] virtual std::int64_t lead() const { return 0; }

  /// Called once before the audio thread begins to render. All that begins within the lead was asked for.
  virtual void begin() {}

  /// Called once after the audio thread has rendered the last sample.
  virtual void end() {}

  [[nodiscard]] virtual VoiceReport report() const { return {}; }

  // The audio thread's part.

  /// Adds the next samples, Pa, [frames x channels]. Voices that lock or allocate are played live by a BufferedVoice.
  /// @param clock  ns of the steady clock at the start of the block
  virtual void render(std::span<double> sound, std::int64_t clock) = 0;
};

}  // namespace idiophone::voices
