#pragma once
// Points that hear and go from place to place.

#include <cstdint>
#include <deque>
#include <vector>

#include "idiophone/instruments/voices/audience.hpp"

namespace idiophone::voices {

class MovingPoints {
 public:
  /// @param points  where they are at first
  explicit MovingPoints(std::vector<HearingPoint> points);

  [[nodiscard]] std::size_t count() const { return from_.size(); }

  /// In the order of their starts.
  void go(const ListenerPlace& place) { moves_.push_back(place); }

  /// Begins the moves that are due. @return whether one began
  bool begin_due(std::int64_t sample);

  /// Audio samples from one on until a move begins, at most `most`.
  [[nodiscard]] std::int64_t samples_without_change(std::int64_t sample, std::int64_t most) const;

  /// One of them, after begin_due() for this audio sample or an earlier one.
  [[nodiscard]] HearingPoint at(std::size_t point, std::int64_t sample) const;

  /// Where they go last, or are. @return [points]
  [[nodiscard]] const std::vector<HearingPoint>& goal() const { return to_.points; }

 private:
  std::vector<HearingPoint> from_;
  ListenerPlace to_;
  std::deque<ListenerPlace> moves_;  // that did not begin
};

/// How a sound that is emitted at a place is heard at a point.
struct Hearing {
  double distance = 1.0;  ///< m
  double gain = 1.0;      ///< of the pressure at 1 m: the point's sensitivity in that direction over the distance
};

/// @param nearest  m: places that are nearer count as that far away
[[nodiscard]] Hearing hearing(const HearingPoint& point, const Vector3& place, double nearest);

}  // namespace idiophone::voices
