#pragma once
// Decks of bodies whose blows were recorded (docs/use/sound_map.md, Measured bodies).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::measured_maps {

/// A blow and its sound.
struct RecordedBlow {
  std::filesystem::path sound;               ///< WAV, FLAC, ...; one channel for each microphone
  Vector3 at = Vector3::Zero();              ///< point of the surface, m
  Vector3 direction = -Vector3::UnitZ();     ///< of the force on the body; unit vector
  double impulse = 1.0;                      ///< integral of the force over time, N s
  double contact = 0.0;                      ///< duration of a half-sine force, s; 0: short against all periods
  std::vector<std::array<double, 2>> force;  ///< rows of (time since the blow in s, N); takes the place of both
  std::optional<double> time;                ///< of the blow in the recording, s; else it is found from the sound
  deck::Location sound_where;
  deck::Location at_where;

  /// How long the force lasts, s.
  [[nodiscard]] double force_duration() const { return force.empty() ? contact : force.back()[0]; }
};

struct MeasuredBody {
  std::string name;
  scene::Body shape;        ///< mesh and place; no material
  double mass = 0.0;        ///< kg
  double full_scale = 1.0;  ///< pressure of the sample 1 in the recordings, Pa
  double duration = 2.0;    ///< of a recording that is analysed, at most, s
  std::vector<RecordedBlow> blows;
  deck::Location where;
};

struct MeasuredDeck {
  scene::Scene scene;  ///< name, listeners, which are the microphones, and radiation; without bodies
  std::vector<MeasuredBody> bodies;
  std::string resolved;  ///< the deck with the overrides in their places and the defaults of the keys it leaves out
};

/// Whether a deck has measured bodies: the key `measured_bodies`.
/// @throws deck::DeckError if it is no YAML; std::runtime_error if the file can't be read
[[nodiscard]] bool has_measured_bodies(const std::filesystem::path& deck, const std::vector<std::string>& overrides);

/// Reads and validates a deck of measured bodies: name, measured_bodies, listeners and radiation. Sounds and meshes are
/// not read yet.
/// @throws deck::DeckError with every mistake found, each with its place; std::runtime_error if the file can't be read
[[nodiscard]] MeasuredDeck read_measured_deck(const std::filesystem::path& deck,
                                              const std::vector<std::string>& overrides);

}  // namespace idiophone::measured_maps
