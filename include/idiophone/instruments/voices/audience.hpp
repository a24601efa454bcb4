#pragma once
// Who hears a stage, and where.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/scene/listeners.hpp"

namespace idiophone::voices {

/// A point that hears, at one moment.
struct HearingPoint {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 axis = Vector3::UnitZ();     ///< as scene::Receiver
  double directivity = 0.0;            ///< likewise
};

/// The listener goes evenly from where it was to a place.
struct ListenerPlace {
  std::int64_t start = 0;              ///< audio sample
  std::int64_t length = 1;             ///< audio samples
  std::vector<HearingPoint> points{};  ///< [receivers], or the middle of the head
};

/// The listener of a stage, the fixed receivers of sound maps, or nobody: then sounds are heard as they are.
class Audience {
 public:
  /// Nobody in particular: one channel.
  Audience() = default;
  /// @throws std::runtime_error if the responses of its head can't be read
  Audience(scene::Listener listener, int rate);
  /// Without the head of the listener.
  explicit Audience(scene::Listener listener) : listener_(std::move(listener)) {}
  /// Receivers at these places, that do not move.
  explicit Audience(std::vector<HearingPoint> receivers) : fixed_(std::move(receivers)) {}

  /// Channels.
  [[nodiscard]] std::size_t receivers() const;
  /// Whether its receivers are those of sound maps.
  [[nodiscard]] bool is_fixed() const { return !fixed_.empty(); }
  /// Whether it has a path of its own.
  [[nodiscard]] bool moves() const { return listener_ && listener_->path; }
  /// Whether move_to() can move it.
  [[nodiscard]] bool can_be_moved() const { return listener_ && !listener_->path; }

  /// Where it is heard at a time, s: [receivers], or the middle of the head; none if there is nobody.
  [[nodiscard]] std::vector<HearingPoint> points(double time) const;

  /// Where it looks: a unit vector; zero for a point that hears all directions alike, and for receivers of sound maps.
  [[nodiscard]] Vector3 look() const;

  /// The middle of its receivers goes there.
  void move_to(const Vector3& position);
  /// By how much that would move it, m.
  [[nodiscard]] double way_to(const Vector3& position) const;

  [[nodiscard]] bool has_head() const { return head_ != nullptr; }
  /// [2 x taps] responses of the ears to sound from a place. @param point  the middle of the head
  [[nodiscard]] std::vector<double> head_responses(const Vector3& place, const HearingPoint& point) const;

 private:
  [[nodiscard]] Vector3 shift_to(const Vector3& position) const;

  std::optional<scene::Listener> listener_;
  std::vector<HearingPoint> fixed_;
  /// [2 x taps] responses of the ears to a direction in the frame of the head; null without a head.
  std::function<std::vector<double>(const Vector3& direction)> head_;
  Vector3 shift_ = Vector3::Zero();  // from where the listener was at first, m
};

/// The middle of some points. @param points  at least one
[[nodiscard]] Vector3 middle_of(std::span<const HearingPoint> points);

}  // namespace idiophone::voices
