#pragma once
// The bodies of a stage: where they are, and the forces that reach them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/touching/contact_sounds.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "moving_body.hpp"
#include "struck_bodies.hpp"

namespace idiophone::engines {

using touching::ContactForce;

class StageBodies {
 public:
  /// @param maps  none of them null
  /// @param ears  [channels] at first, m
  StageBodies(const std::vector<SharedMap>& maps, std::vector<Vector3> ears, const StageOptions& options);

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] voices::SoundMapVoices& voices() { return voices_; }

  void place(std::size_t body, const Pose& pose) { bodies_[body].place(pose); }
  /// @param ears  [channels] m
  void listen(std::vector<Vector3> ears) { ears_ = std::move(ears); }

  /// What reaches the bodies in a step, as far as the budget has room: the listener first, then the forces that he
  /// hears.
  /// @param start, length  audio samples
  void send(std::span<const ContactForce> forces, std::int64_t start, std::int64_t length);

  /// Forces for which the budget had no room, so far.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

  /// Contacts that may scrape or roll at once, so that their bodies do not take more than their share of the budget.
  [[nodiscard]] std::size_t most_strokes() const;

 private:
  [[nodiscard]] std::vector<double> costs() const;
  [[nodiscard]] std::vector<drivers::Excitation> chosen(std::span<const ContactForce> forces, std::int64_t start);
  void send(std::size_t body, const drivers::Excitation& excitation, std::int64_t start, std::int64_t length);

  double budget_;
  std::vector<Vector3> ears_;  // in the world
  voices::SoundMapVoices voices_;
  std::vector<MovingBody> bodies_;
  StruckBodies struck_;
  std::uint64_t left_out_ = 0;
};

}  // namespace idiophone::engines
