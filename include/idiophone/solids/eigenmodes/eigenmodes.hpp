#pragma once
// Small free vibrations of a body, or of several that joints tie together, about where they rest, as a deck holds them:
// K x = (2 pi f)^2 M x, by SLEPc.

#include <mpi.h>

#include <optional>
#include <vector>

#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::eigenmodes {

class Operators;

/// The lumped mass is what the motion in time has. With the consistent one, frequencies of straight-sided elements are
/// upper bounds of those of the solid.
enum class MassMatrix { lumped, consistent };

struct Options {
  int count = 20;                              ///< of modes wanted, the lowest ones; rigid motions do not count
  std::optional<double> up_to = std::nullopt;  ///< Hz: all modes up to there are wanted, and `count` is ignored
  MassMatrix mass = MassMatrix::lumped;
  std::optional<double> shift = std::nullopt;  ///< the search begins so far below zero, Hz; default: a tenth of a rough
                                               ///< estimate of the lowest frequency
  bool align_double_modes = false;  ///< of one frequency, so that few products of three modes are not zero on a round
                                    ///< body. On one rank only
  PartWatch watch = {};             ///< of the search, in modes; no mode is missing below those that it leaves
};

/// One way to vibrate.
struct Mode {
  double frequency = 0.0;           ///< without damping, Hz; of a material with a loss factor, with its moduli there
  double lossless_frequency = 0.0;  ///< with the elastic constants of the deck, Hz
  double damping_ratio = 0.0;       ///< zeta, that of critical damping is 1, as material and supports damp it
  double decay_time = 0.0;  ///< T60, the time in which its sound falls by 60 dB, s; infinity where nothing damps it.
                            ///< Above critical damping, that of the slower of its two motions
  std::vector<double> kinetic_shares;  ///< [bodies] of the kinetic energy, by the lumped mass; they add up to 1
  std::vector<double> shape;  ///< [3 x owned nodes] of unit modal mass, x^T M x = 1 kg m2, so it is in m; the largest
                              ///< component is positive
};

struct Modes {
  int rigid_motions = 0;    ///< in how many ways the body can move without being strained: 6 where nothing holds it
  double shift = 0.0;       ///< that was taken, Hz
  std::vector<Mode> modes;  ///< ascending
};

/// Finds the lowest modes. Fixed and driven groups are held, supports and joints are springs; contacts, loads and
/// gravity are left out. Collective; frequencies are the same on any number of ranks to some 1e-9 of themselves.
/// @param solids  one body, or bodies that joints tie together
/// @param part    this rank's share of them
/// @throws std::runtime_error where all of the body is held, it has not so many modes or none up to that frequency, a
///         shift of zero is asked for a body that can move rigidly, an element is inverted, or the solver fails
[[nodiscard]] Modes find_modes(const scene::Solids& solids, const mesh::Part& part,
                               const motion::Attachments& attachments, const Options& options, MPI_Comm communicator);
/// The same with matrices that are known.
/// @param operators  of these solids; their mass counts, not that of the options
[[nodiscard]] Modes find_modes(const scene::Solids& solids, const mesh::Part& part, const Operators& operators,
                               const Options& options, MPI_Comm communicator);

}  // namespace idiophone::eigenmodes
