#pragma once
// The bodies of a stage: where they are, and the forces that reach them.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
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
  /// @param ears    [channels] at first, m
  /// @param budget  processor time per time of sound
  /// @param shared  this budget, with the proxies; null if it has no limit
  StageBodies(const std::vector<SharedMap>& maps, std::vector<Vector3> ears, const StageOptions& options, double budget,
              std::shared_ptr<voices::SharedBudget> shared);

  /// Whether a body has this number.
  [[nodiscard]] bool has(std::size_t number) const { return number < bodies_.size() && bodies_[number].has_value(); }
  /// Numbers that bodies have or had.
  [[nodiscard]] std::size_t size() const { return bodies_.size(); }

  /// Whether no body has this number, or fades with it.
  [[nodiscard]] bool is_free(std::size_t number) const { return voices_.is_free(number); }

  /// @param number  one that is free
  /// @param map     not null
  void add(std::size_t number, const SharedMap& map);
  /// It fades, and its number is free then.
  void remove(std::size_t body);
  [[nodiscard]] voices::SoundMapVoices& voices() { return voices_; }

  void place(std::size_t body, const Pose& pose) { bodies_[body]->place(pose); }
  /// @throws std::runtime_error for a tension
  void require_tunable(std::size_t body, const score::Tuning& tuning) const { voices_.require_tunable(body, tuning); }
  /// @param start  audio sample
  void tune(std::size_t body, const score::Tuning& tuning, std::int64_t start);
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
  void join(std::size_t body, const SharedMap& map, std::span<const Vector3> ears);
  [[nodiscard]] std::vector<drivers::Excitation> chosen(std::span<const ContactForce> forces, std::int64_t start);
  void send(std::size_t body, const drivers::Excitation& excitation, std::int64_t start, std::int64_t length);

  double budget_;
  int rate_;
  std::vector<Vector3> ears_;  // in the world
  voices::SoundMapVoices voices_;
  std::vector<std::optional<MovingBody>> bodies_;  // by number; none: free, or it fades
  std::map<std::weak_ptr<const sound_maps::SoundMap>, double, std::owner_less<>> loudness_;  // loudness_of()
  StruckBodies struck_;
  std::uint64_t left_out_ = 0;
};

}  // namespace idiophone::engines
