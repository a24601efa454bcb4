#pragma once
// One body of the engine: its levels of detail, one of which sounds, and the forces on it.

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"
#include "up_sampling.hpp"

namespace idiophone::proxies {

/// A level of detail: which lattice, and which part of the audio rate.
struct Detail {
  std::size_t level = 0;
  int divisor = 1;
  double cost = 0.0;  ///< springs per second of sound
};

class Voice {
 public:
  Voice(BodyOptions body, const EngineOptions& options, std::size_t number);

  [[nodiscard]] const BodyOptions& body() const { return body_; }
  [[nodiscard]] const std::vector<Detail>& details() const { return details_; }  ///< the most expensive first
  [[nodiscard]] const Detail& detail() const { return details_[chosen_]; }       ///< that sounds
  [[nodiscard]] bool may_have(const Detail& detail) const { return !level_ || detail.level == *level_; }
  [[nodiscard]] double smallest_cost() const;  ///< of the details that it may have

  [[nodiscard]] bool sounds() const { return sounds_; }                ///< computing time is spent
  [[nodiscard]] bool is_active() const { return sounds_ && !fades_; }  ///< it counts among the active proxies
  /// Now, where the listener is now, while it is active.
  [[nodiscard]] double priority() const { return priority_with(strength_); }

  /// Priority that a force gives the body now.
  [[nodiscard]] double priority_of(const Force& force) const { return priority_with(strength_of(force)); }

  /// By how much its sound at 1 m is multiplied where the listener is.
  [[nodiscard]] double loudness() const;

  void move_listener(const Vector3& listener, const Vector3& front);
  void set_level(std::optional<std::size_t> level) { level_ = level; }
  void set_priority(double priority) { body_.priority = priority; }

  /// @throws std::invalid_argument when it can't be tuned so
  void require_tunable(const Tuning& tuning) const;

  /// Springs and dampers of all levels change, whether it sounds or not.
  void tune(const Tuning& tuning);

  /// A stable body begins to sound at an audio sample.
  /// @param chosen  index of details()
  void begin(std::size_t chosen, std::int64_t sample);

  /// Whether it breaks if it is overloaded.
  [[nodiscard]] bool is_breakable() const { return sounds_ && std::isfinite(body_.strength.tensile); }

  /// The motion of what sounds.
  [[nodiscard]] Fragment fragment() const;

  /// It goes on as this, the only level from now on. @throws std::invalid_argument as Proxy()
  void go_on_as(const Fragment& fragment);

  /// Nothing breaks any more.
  void hold() { body_.strength = {}; }

  /// Silence at once. @return the forces that act
  std::vector<Force> stop();

  /// Springs and dampers, the last time that they were tuned.
  [[nodiscard]] const Tuning& tuning() const { return tuning_; }

  void fade() { fades_ = true; }     ///< to silence within 2 ms
  void resume() { fades_ = false; }  ///< as loud as before within 2 ms

  /// A force from now on, on a body that sounds.
  void add(Force force);

  /// Adds its sound at 1 m to audio samples from `first` on. Returns the number of samples after which it is stable, or
  /// all.
  std::size_t render(std::int64_t first, std::span<double> sound);

 private:
  struct ActingForce {
    Force force;
    Contact contact;
    std::size_t taken = 0;  ///< audio samples of the curve that have acted
  };
  [[nodiscard]] Proxy& proxy() { return proxies_[detail().level]; }
  [[nodiscard]] double strength_of(const Force& force) const;
  [[nodiscard]] double priority_with(double strength) const;
  [[nodiscard]] Vector3 direction_to_listener() const;
  void make_proxies();
  void find_details();
  void begin_turn();
  void take_forces(std::int64_t sample);
  [[nodiscard]] double next_value();
  void end();

  BodyOptions body_;
  EngineOptions options_;
  std::vector<Proxy> proxies_;  // [levels]
  std::vector<Detail> details_;
  UpSampler up_sampler_;
  std::size_t number_;                // in the engine
  std::optional<std::size_t> level_;  // the only one that it may have
  Vector3 front_ = Vector3::Zero();   // in which the listener looks
  Tuning tuning_;
  std::size_t chosen_ = 0;
  bool sounds_ = false, fades_ = false;
  double gain_ = 1.0;
  double strength_ = 0.0;                                      // of the strongest force since it began, N s/kg
  double mobility_ = 1.0;                                      // by which forces are multiplied: 1 over the size
  std::int64_t origin_ = 0;                                    // audio sample at which it began
  std::int64_t quiet_ = 0;                                     // audio samples since it was stable
  double volume_velocity_ = 0.0, next_volume_velocity_ = 0.0;  // of the interval before
  std::int64_t turn_ = -1;  // audio samples since it began to turn to where the listener is; -1: it does not
  std::vector<ActingForce> acting_;
  std::vector<PointForce> point_forces_;
};

}  // namespace idiophone::proxies
