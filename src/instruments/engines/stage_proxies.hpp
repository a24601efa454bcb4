#pragma once
// The proxies of a stage. The thread of the game computes them up to where the next step begins, so that they may take
// memory and time. The audio thread plays what is ready.

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/touching/contact_sounds.hpp"
#include "idiophone/instruments/voices/proxy_voices.hpp"
#include "proxy_motion.hpp"
#include "ready_sound.hpp"

namespace idiophone::engines {

class StageProxies {
 public:
  /// @param ears    [channels] at first, m
  /// @param budget  processor time per time of sound, as the maps have it
  /// @param shared  this budget, with the maps; null if it has no limit
  StageProxies(std::vector<Vector3> ears, StageOptions options, double budget,
               std::shared_ptr<voices::SharedBudget> shared);

  // The part of the thread of the game.

  [[nodiscard]] bool has(std::size_t number) const { return number < size() && bodies_[number].motion; }
  /// Numbers that bodies have or had.
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }

  /// @param number  one that is free
  /// @param sample  audio sample from which on sound is computed next
  /// @throws std::runtime_error when its springs are too fast for the rate
  void add(std::size_t number, const proxies::StoredBody& proxy, std::int64_t sample);
  /// It fades, and its number is free at once.
  void remove(std::size_t number);

  void place(std::size_t number, const Pose& pose);
  /// @param ears  [channels] m
  void listen(std::vector<Vector3> ears);
  /// @throws std::runtime_error when its springs would be too fast for the rate
  void require_tunable(std::size_t number, const score::Tuning& tuning) const;
  /// @param start  audio sample
  void tune(std::size_t number, const score::Tuning& tuning, std::int64_t start);

  /// What reaches the bodies in a step. @param start, length  audio samples
  void send(std::span<const touching::ContactForce> forces, std::int64_t start, std::int64_t length);

  /// Computes the sound until an audio sample.
  void compute_until(std::int64_t sample);

  /// Adds what it knows: proxies, their cost, gaps, and forces that were left out.
  void note(StageReport& report) const;

  // The audio thread's part.

  /// Adds the next samples, Pa, [frames x channels]. @param sample  audio sample of the first
  void render(std::int64_t sample, std::span<double> sound);

 private:
  struct Body {
    std::size_t voice = 0;                    ///< its number in the voices
    std::shared_ptr<ProxyMotion> motion{};    ///< in samples of the voices; null: no body has the number
    std::optional<Eigen::Isometry3d> goal{};  ///< for the next step
    Eigen::Isometry3d to_body = Eigen::Isometry3d::Identity();
  };
  void begin(std::int64_t sample);
  void move(Body& body, std::int64_t start, std::int64_t length);
  /// Audio sample of the stage at which the voices' first one is heard, if there is no other pause.
  [[nodiscard]] std::int64_t origin() const { return origin_ + ready_->delay(); }

  StageOptions options_;
  double budget_;
  std::shared_ptr<voices::SharedBudget> shared_;
  std::vector<Vector3> ears_;                  // in the world
  bool ears_moved_ = false;                    // since the last step
  std::vector<Body> bodies_;                   // by number
  std::optional<voices::ProxyVoices> voices_;  // from the first proxy on
  std::unique_ptr<ReadySound> ready_;          // likewise
  std::int64_t origin_ = 0;                    // audio sample of the voices' first one, without pauses
  std::int64_t computed_ = 0;                  // samples of the voices
  std::vector<double> block_;
  std::uint64_t left_out_ = 0;
  std::atomic<ReadySound*> played_{nullptr};  // for the audio thread
};

}  // namespace idiophone::engines
