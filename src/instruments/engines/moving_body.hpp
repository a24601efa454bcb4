#pragma once
// A body of a stage that moves: the listener in its coordinates.

#include <Eigen/Geometry>
#include <optional>

#include "idiophone/instruments/engines/contact_events.hpp"
#include "idiophone/instruments/resonators/point_forces.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/audience.hpp"

namespace idiophone::engines {

class MovingBody {
 public:
  /// At first where its map is.
  /// @param ears  [channels] as the voices know them, m
  MovingBody(const sound_maps::SoundMap& map, std::span<const Vector3> ears, int rate);

  void place(const Pose& pose);

  /// Into the coordinates of the body.
  [[nodiscard]] resonators::PointForce in_body(const resonators::PointForce& force) const;

  /// What a force until an audio sample excites sounds on until it has fallen by 100 dB.
  void sound_until(std::int64_t sample);

  /// How the listener has to move for a body that sounds, or is about to. At once if it was silent.
  /// @param ears   in the world, m
  /// @param start, length  of the step, audio samples
  /// @param begins  whether a force acts from this step on
  [[nodiscard]] std::optional<voices::ListenerPlace> follow(std::span<const Vector3> ears, std::int64_t start,
                                                            std::int64_t length, bool begins);

 private:
  [[nodiscard]] std::vector<voices::HearingPoint> points(std::span<const Vector3> ears) const;

  Eigen::Isometry3d to_body_ = Eigen::Isometry3d::Identity();
  Vector3 centre_;
  double farthest_;       // place of an ear from the centre, m
  std::int64_t ringing_;  // audio samples
  std::int64_t silent_from_ = 0;
  std::vector<Vector3> known_;  // ears as the voices know them
};

}  // namespace idiophone::engines
