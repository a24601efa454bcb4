#pragma once
// A sonic scene as a program describes it (Hahn 1995, figure 4), and its rendering. The functions mirror those of the
// paper: SrTimbreTree, SrInstantiateSound, SrStartSound and SrStopSound.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "idiophone/scene/acoustics.hpp"
#include "idiophone/timbre/language/binding.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"
#include "idiophone/timbre/track/track_object.hpp"

namespace idiophone::timbre {

struct SoundStart;
struct Tree;

/// A function of time through given values. @param keys  rows of (time in s, value), times ascending
[[nodiscard]] std::shared_ptr<const Curve> time_dependent_variable(const timbre::Keyframes& keys);

/// The samples of one listener.
struct TrackSound {
  std::string listener;  ///< "sound" if the scene has none
  std::size_t channels = 1;
  std::vector<double> samples;  ///< [channels x frames]
};

struct SoundClassHandle {
  std::size_t index;
};

class Soundtrack {
 public:
  /// @param acoustics  rate, listeners, air, floor; must outlive this object
  Soundtrack(const scene::Acoustics& acoustics, std::uint64_t seed);
  Soundtrack(const Soundtrack&) = delete;
  Soundtrack& operator=(const Soundtrack&) = delete;
  Soundtrack(Soundtrack&&) = delete;
  Soundtrack& operator=(Soundtrack&&) = delete;
  ~Soundtrack();

  /// A class of sounds. @throws deck::DeckError for a wrong tree; std::runtime_error if it can't be read
  SoundClassHandle timbre_tree(const std::filesystem::path& file);

  /// Where a sound is at each time (s), m.
  using Path = std::function<Vector3(double time)>;

  /// Where a sound that is not the same in all directions is aimed.
  struct Aim {
    Directivity directivity;
    std::function<Vector3(double time)> axis;  ///< unit vector at a time, s
  };

  /// A sound of a class; silent until it starts.
  /// @param path  without one, the sound is heard as it is
  /// @param aim   of a sound with a path
  SoundHandle instantiate_sound(SoundClassHandle sound_class, double gain = 1.0, Path path = {},
                                std::optional<Aim> aim = {});

  /// From now on, it stands between sounds with a path and the listeners.
  void add_object(TrackObject object) { objects_.push_back(std::move(object)); }

  /// Starts it, once more if it sounds already. Times of one sound ascend. Trees are checked here.
  /// @param time      s
  /// @param bindings  of its parameters from now on
  /// @param duration  s, after which it stops
  /// @throws deck::DeckError when bindings and parameters do not agree, or types are wrong
  void start_sound(SoundHandle sound, double time, Bindings bindings,
                   double duration = std::numeric_limits<double>::infinity());

  /// Stops at this time (s) what was started before.
  void stop_sound(SoundHandle sound, double time);

  /// Called now and then with the number of audio samples that are done.
  using Progress = std::function<void(std::int64_t done)>;

  /// The sound of every listener, from time 0 on.
  /// @throws std::runtime_error for a node whose samples are not finite
  [[nodiscard]] std::vector<TrackSound> render(double duration,
                                               const std::optional<timbre::Reverberation>& reverberation,
                                               const Progress& progress = {}) const;

  /// How often sounds start.
  [[nodiscard]] std::size_t starts() const;
  /// How many of them are at a time (s) or later.
  [[nodiscard]] std::size_t starts_from(double time) const;

 private:
  struct Instance;
  struct Source;

  [[nodiscard]] SoundStart sound_start(std::size_t source, std::size_t start, double time) const;

  scene::Acoustics acoustics_;
  std::uint64_t seed_;
  std::vector<std::unique_ptr<const Tree>> classes_;
  std::vector<Source> sources_;
  std::vector<TrackObject> objects_;

  friend class TrackRenderer;
};

/// The sounds of a sonic scene, bound to the motion.
/// @throws deck::DeckError with the place of what does not agree
void add_sounds(Soundtrack& track, const timbre::SonicScene& scene, const MotionChannels& motion);

}  // namespace idiophone::timbre
