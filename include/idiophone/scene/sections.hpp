#pragma once
// How each section of a deck is read; docs/use/deck.md says what its keys mean. Each read() fills its argument, reports
// every mistake, and returns whether there was none.

#include <span>

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

using deck::Choices;
using deck::DeckError;
using deck::describe;
using deck::Folder;
using deck::infinity;
using deck::Location;
using deck::Mistakes;
using deck::Named;
using deck::Node;
using deck::Range;
using deck::read;
using deck::Section;
using deck::suggestion;

/// time: {duration, steps_per_sample, safety, wall_clock_limit}
bool read(const Node& node, Mistakes& mistakes, Time& time);

/// materials.NAME: {from, young, poisson, shear, stiffness, density, damping}
bool read(const Node& node, Mistakes& mistakes, Material& material);

/// The keys young, poisson, shear and stiffness of a material, which holds those it starts from.
void read_elastic_constants(Section& section, Material& material);

/// Appends the shipped materials whose names the deck does not give to its own.
void add_shipped(std::vector<Material>& materials);

/// bodies.NAME: {mesh, parameters, element, material, materials, layers, grain, prestress, fixed, hinges, driven,
/// supports, model, fracture, springs, velocity, spin}
/// @param so_far  holds the deck's place and the materials
bool read(const Node& node, Mistakes& mistakes, Body& body, const Scene& so_far);

/// The keys material, materials, layers and grain of a body, once element and thickness are read.
void read_materials(Section& section, Body& body, const std::vector<Material>& materials);

/// The key prestress of a body, once its other keys are read.
/// @param materials  of the deck
void read_prestress(Section& section, Body& body, const std::vector<Material>& materials);

/// The key model of a body, once its other keys are read.
void read_model(Section& section, Body& body);

/// The key fracture of a body, once its other keys are read.
void read_fracture(Section& section, Body& body);

/// Refuses what bodies that can break exclude: the radiation model `waves`.
void refuse_fracture(std::span<const Body> bodies, const Radiation& radiation, Mistakes& mistakes);

/// bodies: {NAME: body or recorded body}, at least one of them computed
/// @param deck  holds the section
bool read_bodies(Section& deck, Scene& scene);

/// obstacles.NAME: {shape, at, and what the shape needs}
/// @param so_far  holds the deck's place and the bodies, whose names obstacles may not have
bool read(const Node& node, Mistakes& mistakes, Obstacle& obstacle, const Scene& so_far);

/// contacts: {NAME: {between, friction, damping, stiffness}}; the scene's bodies and obstacles must be there already.
bool read_contacts(Section& deck, Scene& scene);

/// loads: appended to the scene's pulses, plucks, winds and bows; its deck's place and its bodies must be there
/// already.
bool read_loads(const Node& node, Mistakes& mistakes, Scene& scene);

/// joints: {NAME: {type, between, damping, and what the type needs}}; the scene's bodies, materials and
/// loads must be there already.
bool read_joints(Section& deck, Scene& scene);

/// gauges.NAME: {type, points}
/// @param so_far  holds the bodies
bool read(const Node& node, Mistakes& mistakes, Gauge& gauge, const Scene& so_far);

/// listeners.NAME: {type, position or path, and what the type needs}
bool read(const Node& node, Mistakes& mistakes, Listener& listener, const Folder& folder);

/// Refuses listeners that are attached to a body where none moves as a whole.
void refuse_attached(std::span<const Listener> listeners, Mistakes& mistakes);

/// Checks the listeners against the bodies, and the air, the floor and the room of the radiation.
void check_listeners(const Scene& scene, Mistakes& mistakes);

/// The DC block of a deck that does not say.
enum class DefaultDcBlock {
  corner,  ///< 10 Hz
  paper,   ///< alpha = 0.1 (O'Brien 2001, section 3.2): about 740 Hz at 44.1 kHz
};

/// The one that belongs to the model of the deck's section radiation. `huygens` lacks the time derivative of a
/// pressure, so that motion below hearing is louder in it than any tone.
DefaultDcBlock default_dc_block(Section& deck);

/// audio: {rate, max_frequency, kernel_wavelengths, dc_block or dc_corner}
/// @param default_dc_block  without the last two
bool read(const Node& node, Mistakes& mistakes, Audio& audio, DefaultDcBlock default_dc_block);

/// The keys dc_block and dc_corner of audio.
/// @param rate  bounds the corner, Hz
void read_dc_block(Section& section, Audio& audio, double rate, DefaultDcBlock default_dc_block);

/// radiation.room: {size, corner, absorption, images, late}
bool read(const Node& node, Mistakes& mistakes, Room& room);

/// Refuses a late field that hardly decays.
/// @param node   the room's
/// @param speed  of sound, m/s
void check_room(const Node& node, Mistakes& mistakes, const Room& room, double speed);

/// radiation: {model, surface_pressure, visibility, air, floor, room}
/// @param audio  its rate bounds the visibility's
bool read(const Node& node, Mistakes& mistakes, Radiation& radiation, const Audio& audio);

/// The keys wav and wav_full_scale of output.
void read_wav(Section& section, Output& output);

/// output: {frames_per_second, motion_per_second, wav, wav_full_scale, surface_motion, checkpoint}
/// @param audio  its rate bounds the others
bool read(const Node& node, Mistakes& mistakes, Output& output, const Audio& audio);

/// references: {NAME: [frequencies]}; these names are free text
bool read(const Node& node, Mistakes& mistakes, std::vector<ReferenceSet>& references);

/// The keys mesh and parameters of a body or an obstacle.
template <class Shaped>
void read_mesh(Section& section, Shaped& shaped, const Folder& folder);

/// The keys fixed, hinges and driven of a body.
void read_constraints(Section& section, Body& body, const Folder& folder);

struct UnitVector {};
constexpr UnitVector unit_vector;

/// A list of three numbers, not all zero; becomes a vector of length 1.
bool read(const Node& node, Mistakes& mistakes, Vector3& vector, const UnitVector& rule);
[[nodiscard]] Node to_node(const Vector3& vector, const UnitVector& rule);

struct Turn {};
constexpr Turn turn;

struct PolarPattern {};
constexpr PolarPattern polar_pattern;

struct AxisLetters {};
constexpr AxisLetters axis_letters;

struct Grain {};
constexpr Grain grain;

struct FrequencyBand {};
constexpr FrequencyBand frequency_band;

struct TimeAndValue {};
constexpr TimeAndValue time_and_value;

/// Some of the letters x, y and z.
bool read(const Node& node, Mistakes& mistakes, Axes& axes, const AxisLetters& rule);
[[nodiscard]] Node to_node(const Axes& axes, const AxisLetters& rule);

/// omni, cardioid, figure_of_eight, or the d of the pattern 1 - d + d cos(angle).
bool read(const Node& node, Mistakes& mistakes, double& directivity, const PolarPattern& rule);
[[nodiscard]] Node to_node(double directivity, const PolarPattern& rule);

/// grain: {x, y} or {euler}, as a matrix with the three axes in its columns.
bool read(const Node& node, Mistakes& mistakes, Eigen::Matrix3d& axes, const Grain& rule);
[[nodiscard]] Node to_node(const Eigen::Matrix3d& axes, const Grain& rule);

/// A list of two ascending frequencies, Hz.
bool read(const Node& node, Mistakes& mistakes, std::array<double, 2>& range, const FrequencyBand& rule);
[[nodiscard]] Node to_node(const std::array<double, 2>& range, const FrequencyBand& rule);

/// rotation: {axis, degrees}, as axis times angle (rad).
bool read(const Node& node, Mistakes& mistakes, Vector3& rotation, const Turn& rule);
/// Nothing: the default is no rotation.
[[nodiscard]] Node to_node(const Vector3& rotation, const Turn& rule);

/// The keys axis and degrees of a rotation, as axis times angle (rad).
bool read_turn(Section& section, Vector3& rotation);

/// The keys at and radius of a load or a support.
bool read_place(Section& section, PatchPlace& place);

/// The keys shape, start, duration, frequency and table of a load or a driven group.
bool read_signal(Section& section, const Folder& folder, Signal& signal);

/// Rows of a CSV file, as long as its columns.
using CsvRows = std::vector<std::vector<double>>;

/// The columns of a CSV file, the first of which is a time.
struct CsvColumns {
  std::vector<std::string> names;  ///< e.g. {"time", "value"}
};

/// The name of a CSV file with at least two rows of these columns, times from 0 and ascending; # begins a comment.
bool read(const Node& node, Mistakes& mistakes, CsvRows& rows, const Folder& folder, const CsvColumns& columns);

using Table = std::vector<std::array<double, 2>>;  ///< as in Signal: rows of (time in s, value), times ascending

/// The same for the columns time and value.
bool read(const Node& node, Mistakes& mistakes, Table& table, const Folder& folder, const TimeAndValue& rule);

/// The same for the columns time, x, y and z, or such rows as a list: what a listener goes through.
bool read(const Node& node, Mistakes& mistakes, Path& path, const Folder& folder);

/// The alpha of eq. 9 for which the response of pt_i = (1 - alpha) pt_{i-1} + (g_i - g_{i-1}) at the corner frequency
/// (Hz) is 3 dB (a factor of sqrt(2)) below the one at half the rate, its largest.
[[nodiscard]] double dc_loss_at(double corner, double rate);

/// The names of things, for keys that refer to one; each stands for its index.
template <Named T>
Choices<std::size_t> names_of(const std::vector<T>& things) {
  Choices<std::size_t> names;
  for (std::size_t i = 0; i < things.size(); ++i) {
    names.words.emplace_back(things[i].name, i);
  }
  return names;
}

}  // namespace idiophone::scene
