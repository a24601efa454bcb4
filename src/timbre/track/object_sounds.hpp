#pragma once
// What objects change of the sounds on their ways to the listeners.

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "box.hpp"
#include "heard_sounds.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/timbre/nodes/limp_wall.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"

namespace idiophone::timbre {

/// A number that goes from one value to another within an interval.
struct Fade {
  double from = 0.0, to = 0.0;
  [[nodiscard]] double at(double part) const { return from + part * (to - from); }
};

/// The ways from all sources to one microphone or head, by objects. The direct sound is heard elsewhere: here each
/// source emits what its objects change of it, sound behind them less sound without them, and its mirror images emit
/// what they reflect. Ways are found each hundredth of a second, and fade in until the next time.
class WaysToEar {
 public:
  /// @param listener  one microphone or head
  /// @param objects   must outlive this object
  /// @param patterns  [sources]
  WaysToEar(const scene::Acoustics& acoustics, scene::Listener listener, const std::vector<TrackObject>& objects,
            std::vector<PointSources::Pattern> patterns, std::int64_t samples);

  /// @param emission  of the sources
  /// @param boxes     [objects] now
  void hear(std::int64_t sample, const surface::Emission& emission, const std::vector<Box>& boxes);

  /// [receivers x samples]
  [[nodiscard]] const std::vector<double>& sound() const { return heard_->sounds().front(); }

 private:
  /// A wall in the way, and how much of the way is behind it.
  struct Shade {
    LimpWall wall;
    Fade part;
  };
  struct Mirror {
    LimpWall wall;
    Fade part;
    std::optional<Box::Face> face;
  };
  void find_ways(std::int64_t sample, const surface::Emission& emission, const std::vector<Box>& boxes);
  void find_shade(Shade& shade, std::size_t object, const std::optional<Box::Meeting>& crossing) const;
  void find_mirror(Mirror& mirror, std::size_t object, const std::optional<Box::Meeting>& reflection) const;
  void emit(std::size_t source, double part, const surface::Emission& emission, const std::vector<Box>& boxes);
  void place(std::size_t emitter, double pressure, const Vector3& centre, const Vector3& normal);
  [[nodiscard]] double corner(std::size_t object, double cosine) const;

  const std::vector<TrackObject>& objects_;
  std::size_t sources_;
  scene::Scene scene_;           // what is heard: one listener, without floor and room
  std::vector<char> own_;        // [sources x objects] whether it is a sound of the object
  std::vector<Shade> shades_;    // [sources x objects]
  std::vector<Mirror> mirrors_;  // [sources x objects]
  surface::Emission emission_;   // the sources, then the images in their objects
  std::optional<HeardSounds> heard_;
};

/// These ways to all listeners.
class ObjectSounds {
 public:
  /// @param objects   must outlive this object
  /// @param patterns  [sources]
  ObjectSounds(const scene::Acoustics& acoustics, const std::vector<TrackObject>& objects,
               const std::vector<PointSources::Pattern>& patterns, std::int64_t samples);

  /// What the sources emit at an audio sample, one after another.
  void hear(std::int64_t sample, const surface::Emission& emission);

  /// Adds all to the direct sound; once, when everything was heard.
  void add_to(std::vector<TrackSound>& heard) const;

 private:
  const std::vector<TrackObject>& objects_;
  int rate_;
  std::vector<Box> boxes_;
  std::deque<WaysToEar> ears_;
  std::vector<std::size_t> listeners_;  // [ears]
  std::vector<std::size_t> channels_;   // [ears] the first one, of the listener's
};

}  // namespace idiophone::timbre
