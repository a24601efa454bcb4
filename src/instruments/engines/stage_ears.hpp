#pragma once
// The ears of a stage, as voices know their listener.

#include <utility>
#include <vector>

#include "idiophone/instruments/voices/audience.hpp"

namespace idiophone::engines {

/// @param ears  places, m
[[nodiscard]] inline std::vector<voices::HearingPoint> points_at(const std::vector<Vector3>& ears) {
  std::vector<voices::HearingPoint> points;
  points.reserve(ears.size());
  for (const Vector3& ear : ears) {
    points.push_back({.position = ear});
  }
  return points;
}

[[nodiscard]] inline voices::Audience audience_at(const std::vector<Vector3>& ears) {
  scene::Listener listener;
  listener.receivers.reserve(ears.size());
  for (const Vector3& ear : ears) {
    listener.receivers.push_back({.channel = "ear", .position = ear});
  }
  return voices::Audience(std::move(listener));
}

}  // namespace idiophone::engines
