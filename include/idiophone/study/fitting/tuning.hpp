#pragma once
// Numbers of a deck that give the modes of a body wanted frequencies (docs/use/tune.md).

#include <string>
#include <vector>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/study/fitting/target.hpp"
#include "idiophone/study/fitting/variables.hpp"
#include "idiophone/study/fitting/watch.hpp"

namespace idiophone::fitting {

struct TuningOptions {
  std::vector<int> modes;  ///< numbers from 1 on of the modes to tune, at the start; as many as the target's values
  double tolerance = 2.0;  ///< cents
  std::vector<WantedDecay> decays = {};  ///< of any modes
  double decay_tolerance = 5.0;          ///< percent
  std::vector<WantedLevel> levels = {};  ///< of the deck's blows on the body
  double level_tolerance = 0.5;          ///< dB
  std::vector<Band> avoided = {};        ///< where no mode shall be in the end, tuned or not
  std::string body = {};                 ///< that is tuned; empty for the first
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::lumped;
  Watch watch = {};  ///< none: the search goes on to its end
};

/// Where a value lies within its bounds.
enum class Bound { none, lower, upper };

struct TunedMode {
  int start_mode = 0;       ///< its number at the start
  int mode = 0;             ///< its number now
  double start = 0.0;       ///< frequency at the start, Hz
  double frequency = 0.0;   ///< now, Hz
  double wanted = 0.0;      ///< Hz; of ratios with the first mode's frequency
  double cents = 0.0;       ///< frequency over wanted
  double similarity = 0.0;  ///< of its shape with that at the start: modal assurance criterion, 0 to 1
  double mesh_error =
      0.0;                ///< cents by which the mesh makes `frequency` too high, estimated; NaN where that takes long
  std::string kind = {};  ///< mode_kinds::kinds_of() of the tuned body; empty where it has no name
};

/// A mode whose decay time was wanted.
struct TunedDecay {
  int start_mode = 0;                      ///< its number at the start
  int mode = 0;                            ///< its number now
  double start = 0.0;                      ///< T60 at the start, s
  double decay_time = 0.0;                 ///< now, s
  double wanted = 0.0;                     ///< s
  double percent = 0.0;                    ///< now above wanted
  std::vector<double> sensitivities = {};  ///< [variables] percent per unit of the variable
};

/// How loud the blows are at a listener.
struct TunedLevel {
  WantedLevel wanted;
  double start = 0.0;                      ///< LAE at the start, dB re 20 uPa
  double level = 0.0;                      ///< now, dB
  bool is_reached = false;                 ///< within the tolerance, or beyond the limit
  std::vector<double> sensitivities = {};  ///< [variables] dB per unit of the variable; 0 beyond a limit
};

/// What sounds in a band that is to be avoided.
struct AvoidedBand {
  Band band;
  std::vector<int> modes = {};           ///< their numbers now, from 1 on; none is as it should be
  std::vector<double> frequencies = {};  ///< of these modes, Hz
};

/// Sensitivities are NaN where the search ended before it had computed those of its best values.
struct Tuning {
  std::vector<double> values = {};                      ///< [variables]
  std::vector<Bound> bounds = {};                       ///< [variables] that each value sits on
  std::vector<TunedMode> modes = {};                    ///< in the target's order
  std::vector<std::vector<double>> sensitivities = {};  ///< [modes][variables] cents per unit of the variable
  std::vector<TunedDecay> decays = {};                  ///< [TuningOptions::decays]
  std::vector<TunedLevel> levels = {};                  ///< [TuningOptions::levels]
  std::vector<AvoidedBand> avoided = {};                ///< [TuningOptions::avoided]
  bool is_tuned = false;  ///< all modes, decays and levels are within the tolerances, and no mode is in an avoided band
  std::string refusal = {};  ///< why the last shape that was refused can't be, if one was
  int solves = 0;            ///< bodies meshed and solved
  bool stopped = false;      ///< the watch ended the search
};

/// Searches for values within the bounds, from the start: Gauss-Newton with Levenberg's damping. Derivatives are
/// differences over a hundredth of the bounds, with new meshes. Modes are recognised by their shapes, not their order:
/// by the modal assurance criterion with the last accepted shape, sampled at the same places relative to the body's
/// box. A search that ends outside the tolerance begins again at other points between the bounds (Halton 1960), to
/// which the modes are followed from the start; the best end counts. Decay times are those by the material and the
/// supports, without air. Levels are those of the sound map that `idiophone map` would make. On this rank alone.
/// @throws std::runtime_error if a target's frequency is to be avoided, if nothing damps a mode whose decay time is
///         wanted, if a level is wanted at a listener that the deck has not, or if a mode can't be recognised next to
///         the start; deck::DeckError if a level is wanted of a body without forces; what `scene_of`, mesh::read_mesh()
///         and eigenmodes::find_modes() throw there
[[nodiscard]] Tuning tune(const SceneOf& scene_of, const std::vector<Variable>& variables, const Target& target,
                          const TuningOptions& options);

}  // namespace idiophone::fitting
