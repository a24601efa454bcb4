#pragma once
// The constants of a material from what was measured on a body of it (docs/method/identify.md).

#include <optional>
#include <string>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/study/fitting/measurements.hpp"
#include "idiophone/study/fitting/watch.hpp"

namespace idiophone::fitting {

struct IdentificationOptions {
  /// Names of the constants to fit, and of the turns turn_x, turn_y and turn_z of a material that is not isotropic,
  /// about its own axes. "constants" stands for all constants, "turns" for the three turns. Empty: all constants.
  std::vector<std::string> constants = {};
  double tolerance = 50.0;                    ///< the largest distance of a line from its mode, cents
  std::optional<int> lines = {};              ///< fit only so many, the lowest; the others show how well it predicts
  std::optional<double> turn_deviation = {};  ///< standard deviation of each turn beforehand, rad; 0.3 (17 degrees) if
                                              ///< omitted. The search begins within twice that
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::consistent;
  Watch watch = {};  ///< none: the search goes on to its end
};

struct IdentifiedConstant {
  std::string name;         ///< as IdentificationOptions::constants takes it
  double value = 0.0;       ///< Pa, no unit, or degrees of a turn from the deck's axes
  double start = 0.0;       ///< in the deck
  double half_width = 0.0;  ///< of its 95 % confidence interval; infinite if the search was stopped before
  bool determined = true;   ///< it was fitted; if not, the lines do not need it and it has its value in the deck
  bool would_be_determined = false;  ///< by Identification::further; only if it is not
  bool has_no_effect = false;        ///< a turn about an axis around which the material is the same in all directions
};

/// A line and the modes that it is.
struct AssignedLine {
  Line line;
  int first_mode = 0;       ///< from 1 on
  int modes = 0;            ///< so many of one frequency; 0: a false line
  double computed = 0.0;    ///< Hz
  double cents = 0.0;       ///< measured over computed
  double mesh_error = 0.0;  ///< cents by which the mesh may make the mode of a fitted line wrong
  bool is_fitted = false;   ///< if not, it only tests the fit, or is_split
  bool is_split = false;    ///< within 10 cents of a line that takes the place of the mode: the mode is split, or beats
};

/// Modes of one frequency between the lowest and the highest line that no line shows.
struct MissingModes {
  int first_mode = 0;      ///< from 1 on
  int modes = 0;           ///< so many
  double frequency = 0.0;  ///< Hz
};

/// A mode without a line that tells much of a constant that the lines do not determine.
struct FurtherLine {
  std::string constant;
  int first_mode = 0;       ///< from 1 on
  int modes = 0;            ///< so many of one frequency
  double frequency = 0.0;   ///< computed, Hz
  double half_width = 0.0;  ///< of the constant's 95 % interval with this line and those named before
  Vector3 place;            ///< of the surface where the mode moves most, m: strike there, or listen there
  Vector3 direction;        ///< of length 1, in which it moves there; of several modes, the one that moves most there
};

/// A specimen of another size, of the same material and held in the same way, that tells a constant which neither the
/// lines nor further ones of this specimen determine.
struct FurtherSize {
  std::string constant;
  double factor = 1.0;         ///< by which one of its sides is longer than this specimen's
  Vector3 along;               ///< this side, of length 1
  Vector3 extents;             ///< of that specimen, m: its sides, descending
  int lines = 0;               ///< to measure: those of as many lowest modes as lines here, but 10 to 20 modes
  double highest = 0.0;        ///< of their frequencies, Hz
  double half_width = 0.0;     ///< of the constant's 95 % interval, from these lines alone
  bool is_determined = false;  ///< by them
};

struct Identification {
  scene::Material material;                   ///< as the deck has it, with what was found
  std::vector<IdentifiedConstant> constants;  ///< in the material's order
  std::optional<Eigen::Matrix3d> grain;       ///< scene::Body::grain with the turns that were fitted; none if none were
  std::vector<Vector3> equivalent_turns;      ///< degrees, with which the lines fit as well, by symmetry of the body
  std::vector<AssignedLine> lines;            ///< ascending
  std::vector<MissingModes> missing;          ///< ascending
  std::vector<FurtherLine> further;           ///< that would determine the constants that are not; by constant
  std::vector<FurtherSize> sizes;             ///< for those that no further line determines; one for each at most
  std::vector<std::string> refused_sizes;     ///< sizes that could not be looked at, and why
  double looked_up_to = 0.0;                  ///< Hz, the highest mode among which they were looked for; 0: none were
  std::optional<double> fitted_rms;           ///< root of the mean square of the fitted lines' cents
  std::optional<double> tested_rms;           ///< of the others'; none if there are none
  double chi_squared = 0.0;  ///< sum of the squares of the fitted lines' cents over their uncertainties and mesh errors
  int freedom = 1;           ///< of chi_squared: fitted lines without constants that were fitted, but at least 1
  bool has_damping = false;  ///< the material's damping is from measured decay times
  double volume = 0.0;       ///< of the body, m3
  int solves = 0;            ///< eigenvalue problems solved
  bool stopped = false;      ///< the watch ended the search
  std::vector<std::string> doubts;  ///< why the fit is not accepted, sentences; empty: it explains the lines
};

/// Fits the elastic constants of a body, and turns of its material's axes, to measured lines: Gauss-Newton with
/// Levenberg's damping, weighted by the lines' uncertainties. Derivatives are those of Hellmann and Feynman, exact by
/// the mode shapes. The fit begins with a common factor of all moduli and adds unknowns. A measured mass gives the
/// density, decay times the damping. The 95 % intervals contain the lines' uncertainties, the errors of the mesh and
/// those of constants that are held. A constant whose interval is wider than +-10 %, or of a Poisson's ratio +-0.1,
/// keeps the deck's value if the lines fit as well with it, and further lines are named that would determine it, or
/// another size of the specimen. The fit is not accepted where a line is false, or where the fitted
/// lines are farther from their modes than in 99.9 % of right fits: a chi-squared test of their uncertainties and the
/// errors of the mesh. On this rank alone.
/// @param solids  one body (scene::Solids::alone)
/// @throws std::runtime_error for an unknown constant, turns of an isotropic material, or if no line fits any mode;
/// deck::DeckError for a wrong mesh;
///         what eigenmodes::find_modes() throws
[[nodiscard]] Identification identify(const scene::Solids& solids, const Measurements& measured,
                                      const IdentificationOptions& options);

}  // namespace idiophone::fitting
