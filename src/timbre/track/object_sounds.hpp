#pragma once
// What objects change of the sounds on their ways to the listeners.

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "heard_sounds.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "object_shape.hpp"
#include "shade.hpp"

namespace idiophone::timbre {

/// The objects of a soundtrack as walls.
class Walls {
 public:
  /// @param objects  must outlive this object
  /// @param sounds   [emitters] to which sound each belongs
  Walls(const scene::Acoustics& acoustics, const std::vector<TrackObject>& objects, std::vector<std::size_t> sounds);

  /// Puts the objects where they are at an audio sample.
  void place(std::int64_t sample);

  [[nodiscard]] std::size_t count() const { return objects_.size(); }
  [[nodiscard]] std::size_t emitters() const { return sounds_.size(); }
  [[nodiscard]] const ObjectShape& shape(std::size_t object) const { return shapes_[object]; }
  [[nodiscard]] double absorption(std::size_t object) const { return objects_[object].absorption; }

  /// Whether an emitter is a sound of the object itself.
  [[nodiscard]] bool is_own(std::size_t emitter, std::size_t object) const;

  /// LimpWall::corner() of an object over the rate.
  [[nodiscard]] double corner(std::size_t object, double cosine) const;

  /// Audio samples from one search of ways to the next.
  [[nodiscard]] int interval() const;

 private:
  const std::vector<TrackObject>& objects_;
  std::vector<std::size_t> sounds_;
  std::vector<ObjectShape> shapes_;  // [objects]
  double impedance_;                 // of the air, Pa s/m
  int rate_;
};

/// The ways from all emitters to one microphone or head, by objects: straight, and by way of the floor or of the walls
/// of a room. The sound without objects is heard elsewhere: here each emitter emits along each way what its objects
/// change of it, sound behind them less sound without them, and its mirror images emit what they reflect. Ways are
/// found each hundredth of a second, and fade in until the next time.
class WaysToEar {
 public:
  /// @param listener  one microphone or head
  /// @param walls     must outlive this object
  /// @param patterns  [emitters]
  WaysToEar(const scene::Acoustics& acoustics, scene::Listener listener, const Walls& walls,
            std::vector<PointSources::Pattern> patterns, std::int64_t samples);

  /// @param emission  of the emitters
  void hear(std::int64_t sample, const surface::Emission& emission);

  /// [receivers x samples]
  [[nodiscard]] const std::vector<double>& sound() const { return heard_->sounds().front(); }

 private:
  struct Mirror {
    Shade shade;  ///< its wall passes what the mirror does not reflect
    std::optional<std::size_t> face;
  };
  void find_ways(std::int64_t sample, const surface::Emission& emission);
  void find_shades(std::size_t path, std::size_t emitter, const std::vector<Vector3>& way);
  void find_mirrors(std::size_t emitter, const Vector3& source, const Vector3& ear);
  void emit_behind(std::size_t path, std::size_t emitter, double part, const surface::Emission& emission);
  void emit_mirrored(std::size_t emitter, double part, const surface::Emission& emission);

  const Walls& walls_;
  scene::Scene scene_;                        // what is heard: one listener
  std::vector<Shade> shades_;                 // [paths x emitters x objects]
  std::vector<Mirror> mirrors_;               // [emitters x objects]
  std::vector<surface::Emission> emissions_;  // [paths] the emitters; the direct path then has their mirror images
  std::optional<HeardSounds> heard_;
};

/// These ways to all listeners.
class ObjectSounds {
 public:
  /// @param objects   must outlive this object
  /// @param sounds    [emitters] to which sound each belongs
  /// @param patterns  [emitters]
  ObjectSounds(const scene::Acoustics& acoustics, const std::vector<TrackObject>& objects,
               std::vector<std::size_t> sounds, const std::vector<PointSources::Pattern>& patterns,
               std::int64_t samples);

  /// What the emitters emit at an audio sample, one after another.
  void hear(std::int64_t sample, const surface::Emission& emission);

  /// What of the last emission becomes late sound: that of an emitter inside an object is behind its wall.
  [[nodiscard]] const surface::Emission& late_emission() const { return late_emission_; }

  /// Adds all to the sound without objects; once, when everything was heard.
  void add_to(std::vector<TrackSound>& heard) const;

 private:
  void enclose(std::int64_t sample, const surface::Emission& emission);

  Walls walls_;
  std::vector<Shade> enclosures_;  // [emitters x objects]
  surface::Emission late_emission_;
  std::deque<WaysToEar> ears_;
  std::vector<std::size_t> listeners_;  // [ears]
  std::vector<std::size_t> channels_;   // [ears] the first one, of the listener's
};

}  // namespace idiophone::timbre
