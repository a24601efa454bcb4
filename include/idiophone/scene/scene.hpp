#pragma once
// What a deck describes, validated and with defaults filled in. Plain data; every part that can still turn out wrong
// against the mesh (a group's name, a point on the body) keeps the place in the deck where it was said.

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/scene/location.hpp"
#include "idiophone/types.hpp"

namespace idiophone::scene {

/// Which directions a constraint holds: x, y, z.
using Axes = std::array<bool, 3>;

/// Internal friction that is the same at all frequencies of a band: a mode of frequency f there loses the energy
/// 2 pi `value` of what it has in each period, its amplitude falls as exp(-pi f value t).
struct LossFactor {
  double value = 0.0;                            ///< tan(phi), above 0
  std::array<double, 2> band = {20.0, 20000.0};  ///< Hz, ascending
  std::optional<int> mechanisms;                 ///< of relaxation; as few as will do where not given
  Location where;
};

/// Mass- and stiffness-proportional damping: a mode of angular frequency w has the damping ratio
/// zeta = mass/(2 w) + stiffness w/2. A loss factor adds half of itself.
struct Damping {
  double mass = 0.0;       ///< alpha, 1/s
  double stiffness = 0.0;  ///< beta, s (Kelvin-Voigt: phi = beta lambda, psi = beta mu)
  std::optional<LossFactor> loss = {};
};

/// Elastic constants along three axes at right angles, of wood for instance. poisson ij is how much the material
/// shrinks along j where it is pulled along i, so that nu_ij/E_i = nu_ji/E_j.
struct Orthotropy {
  Vector3 young = Vector3::Zero();    ///< E_x, E_y, E_z, Pa
  Vector3 poisson = Vector3::Zero();  ///< nu_xy, nu_yz, nu_xz
  Vector3 shear = Vector3::Zero();    ///< G_xy, G_yz, G_xz, Pa
};

/// Elastic material.
struct Material {
  std::string name;
  double young = 0.0;    ///< Young's modulus, Pa; the largest of an orthotropic material
  double poisson = 0.0;  ///< Poisson's ratio, in (-1, 0.5); of an isotropic material
  double density = 0.0;  ///< kg/m3
  Damping damping;
  Location where;
  std::optional<Orthotropy> orthotropy = {};  ///< where it is not the same in all directions
};

/// Tetrahedra with linear (the paper's) or quadratic shape functions.
enum class ElementType { tet4, tet10 };

/// A physical group of the mesh held still in some directions.
struct FixedGroup {
  std::string group;
  Axes axes = {true, true, true};
  bool hinge = false;  ///< its nodes must lie on one straight line, about which the body is free to turn
  Location where;
};

/// A function of time without unit: zero before `start`, then one of the shapes.
struct Signal {
  enum class Shape {
    half_sine,  ///< sin(pi t/duration) until `duration`, then zero
    constant,   ///< one until `duration` (for ever where it is infinite)
    sine,       ///< sin(2 pi frequency t) until `duration`
    table       ///< linear between the rows of `table`, zero outside them
  };
  Shape shape = Shape::half_sine;
  double start = 0.0;                        ///< s
  double duration = 0.0;                     ///< s; infinity for no end
  double frequency = 0.0;                    ///< Hz, sine only
  std::vector<std::array<double, 2>> table;  ///< rows of (time after start in s, value), times ascending

  /// Value at `time` (s).
  [[nodiscard]] double at(double time) const;
};

/// A group driven along a path: turned about an axis by rotation * signal(t), then displaced by displacement *
/// signal(t); only the named axes are held to it, all of them where it turns.
struct DrivenGroup {
  std::string group;
  Vector3 displacement = Vector3::Zero();  ///< m
  Vector3 rotation = Vector3::Zero();      ///< axis times angle, rad
  Vector3 pivot = Vector3::Zero();         ///< a point of the axis, m
  Axes axes = {true, true, true};
  Signal signal;
  Location where;

  /// Whether it goes anywhere: false for a path that holds the group still.
  [[nodiscard]] bool moves() const { return !displacement.isZero(0.0) || !rotation.isZero(0.0); }
};

/// A patch of the surface: all within `radius` of the point, or the one surface triangle at the point where it is 0.
struct PatchPlace {
  Vector3 at = Vector3::Zero();  ///< m, in the body's reference configuration
  double radius = 0.0;           ///< m
  Location where;
};

/// A spring and a dashpot, side by side, from a patch to the ground; they act in all directions.
struct Support {
  std::string name;
  PatchPlace place;
  double stiffness = 0.0;  ///< N/m, of the whole patch
  double damping = 0.0;    ///< N s/m, of the whole patch
};

/// One deformable body.
struct Body {
  std::string name;
  std::filesystem::path mesh;  ///< .geo, .msh, .step, .brep or .stl; absolute or from the working directory
  std::map<std::string, double> parameters;  ///< for a .geo file's DefineConstant names; `size` for the others but .msh
  Vector3 rotation = Vector3::Zero();        ///< of the mesh about its file's origin, axis times angle, rad
  Vector3 position = Vector3::Zero();        ///< where the mesh's origin is then put, m
  ElementType element = ElementType::tet10;
  std::size_t material = 0;  ///< index into Scene::materials
  Eigen::Matrix3d grain =
      Eigen::Matrix3d::Identity();  ///< columns: the axes of an orthotropic material in the mesh file
  std::vector<FixedGroup> fixed;
  std::vector<DrivenGroup> driven;
  std::vector<Support> supports;
  Vector3 velocity = Vector3::Zero();  ///< at the start, m/s
  Vector3 spin = Vector3::Zero();      ///< angular velocity at the start about the centre of mass, rad/s
  Location where;
  Location mesh_where;
  std::map<std::string, Location> parameters_where;

  /// The rotation as a matrix.
  [[nodiscard]] Eigen::Matrix3d turn() const;

  /// The material's axes in the undeformed body, in the columns.
  [[nodiscard]] Eigen::Matrix3d material_axes() const { return turn() * grain; }
};

/// A force on a patch of a body, multiplied by a signal.
struct ForcePulse {
  std::string name;
  std::size_t body = 0;  ///< index into Scene::bodies
  PatchPlace place;
  Vector3 force = Vector3::Zero();  ///< N, of the whole patch
  Signal signal;
};

/// The body starts in static equilibrium under this force, which is let go at time 0.
struct Pluck {
  std::string name;
  std::size_t body = 0;  ///< index into Scene::bodies
  PatchPlace place;
  Vector3 force = Vector3::Zero();  ///< N, of the whole patch
};

/// Where something is, and how fast it moves.
struct Place {
  Vector3 position = Vector3::Zero();  ///< m
  Vector3 velocity = Vector3::Zero();  ///< m/s
};

/// Where a listener goes: smoothly through points at given times, before the first and after the last of them straight
/// on. Equal points at either end make it stand there.
struct Path {
  /// A point that it goes through.
  struct Point {
    double time = 0.0;                   ///< s
    Vector3 position = Vector3::Zero();  ///< m
  };
  std::vector<Point> points;  ///< at least two, times ascending
  Location where;

  /// Position and velocity at a time (s), both continuous: cubics between the points (Hermite), whose velocity at a
  /// point is that of the parabola through it and its two neighbours. Points of a steady motion give that motion.
  [[nodiscard]] Place at(double time) const;

  /// No speed is above this, m/s.
  [[nodiscard]] double fastest() const;
};

/// A point that hears: one audio channel.
struct Receiver {
  std::string channel;                 ///< e.g. "ears.left"
  Vector3 position = Vector3::Zero();  ///< m; at time 0 where it moves
  Vector3 axis = Vector3::UnitZ();     ///< unit vector: where a directional microphone looks
  double directivity = 0.0;            ///< d of its sensitivity 1 - d + d cos(angle off the axis)
};

/// A head that hears with two ears, by the responses that were measured at them from many directions.
struct Head {
  Vector3 look = -Vector3::UnitZ();  ///< unit vector: where the nose points
  Vector3 up = Vector3::UnitY();     ///< unit vector across `look`: where the top of the head points
  std::filesystem::path responses;   ///< .sofa, of the convention SimpleFreeFieldHRIR
  Location where;                    ///< of the file's name, or of the listener
};

/// One or two receivers under one name, written to one WAV file and one dataset of one or two channels.
struct Listener {
  std::string name;
  std::vector<Receiver> receivers;  ///< mono: 1; stereo: left, then right (section 4 of the paper: 20 cm apart);
                                    ///< binaural: left, then right, both at the head's centre
  std::optional<Path> path;         ///< what moves the receivers, whose axes keep their directions
  std::optional<Head> head;         ///< binaural only
  Location where;

  /// Where one of its receivers is at a time (s).
  [[nodiscard]] Place place(const Receiver& receiver, double time) const;
};

/// A rigid thing that stands still, cannot be heard, and that bodies touch.
struct Obstacle {
  enum class Shape {
    half_space,  ///< everything behind a plane
    box,         ///< its edges along x, y and z, then turned by `rotation`
    sphere,
    cylinder,
    surface  ///< the inside of a closed triangulated surface, or a mesh of tetrahedra
  };
  std::string name;
  Shape shape = Shape::half_space;
  Vector3 at = Vector3::Zero();          ///< m; half_space: a point of its plane; box, sphere, cylinder: the centre;
                                         ///< surface: where the file's origin is put
  Vector3 direction = Vector3::UnitZ();  ///< unit vector; half_space: its outward normal; cylinder: its axis
  Vector3 size = Vector3::Zero();        ///< box: lengths of its edges, m
  double radius = 0.0;                   ///< sphere, cylinder, m
  double length = 0.0;                   ///< cylinder, m
  Vector3 rotation = Vector3::Zero();    ///< box: axis times angle, rad
  std::filesystem::path mesh;            ///< surface: .stl, .msh, .geo, .step or .brep
  std::map<std::string, double> parameters;  ///< surface: as Body::parameters
  Location where;
  Location mesh_where;
  std::map<std::string, Location> parameters_where;
};

/// Coulomb friction: a contact sticks while the tangential force is below `sticking` times the normal one, and then
/// slides under `sliding` times it. 0 <= sliding <= sticking.
struct Friction {
  double sticking = 0.0;
  double sliding = 0.0;
};

/// Two things that may touch: a body and another body, or a body and an obstacle. Pairs that are not named pass through
/// each other.
struct Contact {
  std::string name;
  std::size_t body = 0;                 ///< index into Scene::bodies
  std::optional<std::size_t> other;     ///< index into Scene::bodies, not `body`; none: `obstacle` counts
  std::optional<std::size_t> obstacle;  ///< index into Scene::obstacles
  Friction friction;
  double damping = 0.0;             ///< relaxation time: pressure = stiffness (depth + damping * its rate), s
  std::optional<double> stiffness;  ///< pressure per depth of overlap, Pa/m; chosen from bodies and mesh if not given
  Location where;
};

/// Time and steps.
struct Time {
  double duration = 0.0;                   ///< of the sound, s
  std::optional<int> steps_per_sample;     ///< m; chosen from the largest eigenfrequency where it is not given
  double safety = 0.9;                     ///< of the largest stable step, in (0, 1]
  std::optional<double> wall_clock_limit;  ///< stop in good order after so many seconds of computing
};

/// Filters and sampling (paper, section 3.2).
struct Audio {
  int rate = 44100;                 ///< samples per second
  double max_frequency = 22050.0;   ///< f_max of eq. 7, Hz
  double kernel_wavelengths = 3.0;  ///< half-width of the low-pass in wavelengths of f_max (the paper's w)
  double dc_loss = 0.0;             ///< alpha of eq. 9, in [0, 1); from the deck's dc_block or its corner frequency
};

/// The air (section 3.2: 20 C, one atmosphere).
struct Air {
  double density = 1.21;  ///< kg/m3
  double speed = 343.0;   ///< m/s

  bool absorption = false;     ///< whether it absorbs sound on its way; the next three then tell how much
  double temperature = 20.0;   ///< degrees Celsius
  double humidity = 50.0;      ///< relative, per cent
  double pressure = 101325.0;  ///< Pa

  /// Specific acoustic impedance z = rho c, Pa s/m.
  [[nodiscard]] double impedance() const { return density * speed; }
};

/// A rigid plane that reflects sound.
struct Floor {
  Vector3 at = Vector3::Zero();          ///< a point of it, m
  Vector3 direction = Vector3::UnitZ();  ///< unit vector: its normal, towards the listeners
  double reflection = 1.0;               ///< reflected pressure over incident pressure, -1 to 1

  /// Distance from it, negative behind it, m.
  [[nodiscard]] double height(const Vector3& point) const { return (point - at).dot(direction); }
};

/// How surfaces are heard (docs/radiation.md).
enum class RadiationModel { huygens, rayleigh, kirchhoff };

/// How model kirchhoff finds the pressure of the air at a surface.
enum class SurfacePressure { plane_wave, pulsating, oscillating };

/// How often it is found out which triangles each receiver sees.
struct Visibility {
  double rate = 100.0;  ///< per second, at most the audio rate

  /// Audio samples between two looks: the nearest whole number.
  [[nodiscard]] std::int64_t interval(int audio_rate) const { return std::llround(audio_rate / rate); }
};

struct Radiation {
  RadiationModel model = RadiationModel::huygens;
  SurfacePressure surface_pressure = SurfacePressure::oscillating;  ///< kirchhoff only

  std::optional<Visibility> visibility = Visibility{};  ///< none: everything is seen from everywhere

  /// Whether the surface pressure depends on the bodies' shapes.
  [[nodiscard]] bool asks_for_radii() const {
    return model == RadiationModel::kirchhoff && surface_pressure != SurfacePressure::plane_wave;
  }

  Air air;
  std::optional<Floor> floor;
};

enum class WavFormat { float32, pcm24, pcm16 };

struct Output {
  double frames_per_second = 60.0;    ///< of the moving mesh; 0 for none
  double motion_per_second = 2000.0;  ///< of the motion channels and energies; 0 for none
  WavFormat wav = WavFormat::float32;
  std::optional<double> wav_full_scale;  ///< pressure that becomes 1.0 in the WAV; the loudest sample's where not given
  double checkpoint_minutes = 15.0;      ///< of wall clock between checkpoints; 0 for none but the one at a stop
  int checkpoint_keep = 3;               ///< newest ones kept
  bool surface_motion = false;           ///< whether the surfaces' motion is recorded, to be listened to later
};

/// Frequencies that the sound is expected to have, drawn into spectra and compared by `analyze`.
struct Reference {
  std::string name;                 ///< e.g. "thin plate (Leissa)"
  std::vector<double> frequencies;  ///< Hz
};

/// All that a deck says.
struct Scene {
  std::string name;
  std::filesystem::path deck;          ///< where it was read from
  std::string deck_text;               ///< verbatim
  std::vector<std::string> overrides;  ///< the --set arguments, verbatim
  Time time;
  std::vector<Material> materials;  ///< the deck's, then the shipped ones (shipped_materials.hpp)
  std::vector<Body> bodies;
  std::vector<ForcePulse> pulses;
  std::vector<Pluck> plucks;
  std::vector<Obstacle> obstacles;
  std::vector<Contact> contacts;
  Vector3 gravity = Vector3::Zero();  ///< m/s2
  std::vector<Listener> listeners;
  Audio audio;
  Radiation radiation;
  Output output;
  std::vector<Reference> references;
};

/// Reads and validates a deck.
/// @param deck       the YAML file
/// @param overrides  "key.path=value" each, validated like the deck itself
/// @throws DeckError with every mistake found, each with its place; std::runtime_error if the file can't be read.
[[nodiscard]] Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {});

}  // namespace idiophone::scene
