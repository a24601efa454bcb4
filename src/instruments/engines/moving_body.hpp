#pragma once
// A body of a stage that moves: the listener in its coordinates.

#include <Eigen/Geometry>
#include <optional>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/resonators/point_forces.hpp"
#include "idiophone/instruments/score/action.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/audience.hpp"

namespace idiophone::engines {

/// A force of the world in the coordinates of a body.
[[nodiscard]] resonators::PointForce in_body(const Eigen::Isometry3d& to_body, const resonators::PointForce& force);

class MovingBody {
 public:
  /// At first where its map is.
  /// @param loudness  loudness_of() the map
  /// @param ears      [channels] as the voices know them, m
  MovingBody(const sound_maps::SoundMap& map, double loudness, std::span<const Vector3> ears, int rate);

  void place(const Pose& pose);

  /// From the world to the coordinates of the body.
  [[nodiscard]] const Eigen::Isometry3d& to_body() const { return to_body_; }

  /// It rings for another time from now on, also what rings at an audio sample.
  void tune(const score::Tuning& tuning, std::int64_t sample);

  /// Of an impact, as the nearest ear hears it, Pa.
  /// @param impulse  N s
  /// @param ears     in the world, m
  [[nodiscard]] double loudness(double impulse, std::span<const Vector3> ears) const;

  /// What a force until an audio sample excites sounds on until it has fallen by 100 dB.
  void sound_until(std::int64_t sample);

  /// What the listener has to know of a body.
  enum class Part {
    struck,   ///< a force acts from this step on
    heard,    ///< of what may ring
    unheard,  ///< it may ring, and the budget has no room for it
  };
  /// How the listener has to move for a body that sounds, or is about to. At once if it was silent. For an unheard body
  /// only if an ear has moved by more than 1 % of its distance.
  /// @param ears   in the world, m
  /// @param start, length  of the step, audio samples
  [[nodiscard]] std::optional<voices::ListenerPlace> follow(std::span<const Vector3> ears, std::int64_t start,
                                                            std::int64_t length, Part part);

 private:
  [[nodiscard]] bool is_near(const voices::HearingPoint& point, const Vector3& known, double tolerance) const;
  [[nodiscard]] std::vector<voices::HearingPoint> points(std::span<const Vector3> ears) const;

  Eigen::Isometry3d to_body_ = Eigen::Isometry3d::Identity();
  Vector3 centre_;
  double loudness_;       // Pa/(N s) at 1 m
  double farthest_;       // place of an ear from the centre, m
  double slowest_;        // decay of its modes, 1/s
  int rate_;              // audio samples per second
  std::int64_t ringing_;  // audio samples
  std::int64_t silent_from_ = 0;
  std::vector<Vector3> known_;  // ears as the voices know them
};

}  // namespace idiophone::engines
