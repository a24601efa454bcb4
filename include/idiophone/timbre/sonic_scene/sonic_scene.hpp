#pragma once
// A sonic scene: which sounds start when, and what their parameters are bound to (Hahn 1995, "Sonic scene description
// language"). `idiophone timbre` reads it (docs/use/timbre.md).

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/sonic_scene/directivity.hpp"

namespace idiophone::timbre {

/// From a number of the motion to a number of the sound: offset + scale sign(x) |x|^curve, within the range.
struct Mapping {
  double scale = 1.0;
  double offset = 0.0;
  double curve = 1.0;
  std::optional<std::array<double, 2>> range;  ///< of the result; everything if empty

  [[nodiscard]] double operator()(double number) const;
};

/// A variable with values at given times.
struct Keyframes {
  std::vector<std::array<double, 2>> keys;  ///< rows of (time in s, value), times ascending
  Interpolation interpolation = Interpolation::linear;
};

/// A motion channel of a result.
struct MotionVariable {
  std::string channel;   ///< e.g. "motion/bell/velocity"
  std::string column{};  ///< empty for the only column, or for the length of the vector of all columns
  Mapping mapping{};
  Interpolation interpolation = Interpolation::linear;
  bool derivative = false;  ///< with respect to time, before the mapping
  deck::Location where;
};

/// A quantity of the contact that started the sound.
struct EventVariable {
  enum class Quantity { force, impulse };  ///< the largest force, N; its integral over time, N s
  Quantity quantity = Quantity::force;
  Mapping mapping;
};

using Variable = std::variant<double, Keyframes, MotionVariable, EventVariable>;

/// A variable with a name of its own, or a parameter of a tree and what it is bound to.
struct NamedVariable {
  std::string name;
  Variable variable;
  deck::Location where;
};

/// A timbre tree that sounds are made of.
struct SoundClass {
  std::string name;
  std::filesystem::path tree;
};

/// Contacts that start a sound.
struct ContactStart {
  std::string contact;  ///< its name in the deck
  double above = 0.0;   ///< N: it begins when the force rises above this one
  double gap = 0.01;    ///< s: it ends when the force was not above for so long
  deck::Location where;
};

/// Where a sound or an object is: one of the three, or none.
struct SonicPlace {
  std::optional<Vector3> at;  ///< m
  std::optional<scene::Path> path;
  std::string body;  ///< of the run, whose centre of mass it moves with; may be empty

  [[nodiscard]] bool is_somewhere() const { return at || path || !body.empty(); }
};

/// A sound of a class.
struct SonicSound {
  std::string name;
  std::size_t sound_class = 0;                                ///< index of the class
  std::vector<NamedVariable> parameters;                      ///< of the tree
  std::vector<double> starts;                                 ///< s
  std::optional<ContactStart> on_contact;                     ///< instead of times
  double duration = std::numeric_limits<double>::infinity();  ///< from each start, s
  double gain = 1.0;
  SonicPlace place;                        ///< a sound without one is heard as it is
  std::optional<Directivity> directivity;  ///< none: the same in all directions
  deck::Location where;
};

/// A box, or the solid in a mesh file, that shades sounds, lets a part of them through by its mass, and reflects the
/// rest (TrackObject).
struct SonicObject {
  std::string name;
  Vector3 size = Vector3::Ones();         ///< lengths of the edges of a box along x, y and z, before the rotation, m
  std::optional<scene::Body> solid;       ///< mesh, its parameters and meshing; none: a box
  Vector3 rotation = Vector3::Zero();     ///< axis times angle, rad; a body turns it further
  SonicPlace place;                       ///< of its centre, or of the origin of the mesh
  std::optional<double> surface_density;  ///< kg/m2; nothing gets through without one
  double absorption = 0.0;                ///< part of the energy that would be reflected
  deck::Location where;
};

/// Late sound of a room.
struct Reverberation {
  double decay = 1.0;  ///< time of a decay by 60 dB, s
  double level = 0.1;  ///< of the reverberation, for sources whose direct sound at 1 m has level 1
};

/// A tree that computes a number of the music over the time of the scene.
struct TreeVariable {
  std::size_t sound_class = 0;            ///< index of the class that has the tree
  std::vector<NamedVariable> parameters;  ///< of the tree
};

/// A number of the music: it is read whenever a note begins.
using MusicVariable = std::variant<double, Keyframes, MotionVariable, TreeVariable>;

/// When a part is silent.
struct Rests {
  MusicVariable value = 0.0;
  double below = 0.0;  ///< there is a rest while the value is less
};

inline constexpr double longest_note = 1000.0;  ///< steps

/// The notes that motion becomes: a mapping for each property of a note.
struct MusicPart {
  std::string name;
  MusicVariable pitch = 0.0;
  std::array<double, 2> from{};          ///< values of `pitch` that become the lowest and the highest note
  std::size_t scale = 0;                 ///< index into musical_scales()
  int tonic = 60;                        ///< number of the lowest note; 60 is c'
  int octaves = 2;                       ///< of the range
  MusicVariable velocity = 96.0;         ///< 1 to 127
  MusicVariable program = 0.0;           ///< General MIDI instrument, 0 to 127
  std::optional<MusicVariable> steps{};  ///< length of a note in steps; without it, equal notes are slurred
  std::optional<Rests> rests{};
};

/// Background music from motion (Hahn 1995, "Mapping motion parameters to music").
struct Music {
  double every = 0.5;  ///< length of a step, s
  std::vector<MusicPart> parts;
};

struct SonicScene {
  scene::Scene scene;     ///< name, listeners, radiation, audio rate and output; without bodies
  double duration = 0.0;  ///< s
  std::uint64_t seed = 1;
  std::vector<SoundClass> classes;
  std::vector<SonicSound> sounds;
  std::vector<SonicObject> objects;
  std::optional<Reverberation> reverberation;
  std::optional<Music> music;
};

/// @throws deck::DeckError with every mistake of the file; std::runtime_error if it can't be read
[[nodiscard]] SonicScene read_sonic_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// The scales that music can have: names, and semitones above the tonic within an octave.
[[nodiscard]] const std::vector<std::pair<std::string, std::vector<int>>>& musical_scales();

}  // namespace idiophone::timbre
