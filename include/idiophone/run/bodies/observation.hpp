#pragma once
// All bodies at one moment: sums on each rank, plain numbers on rank 0.

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/body_motion.hpp"

namespace idiophone::bodies {

struct Observation {
  std::vector<motion::BodyMotion> bodies;
  std::vector<motion::BodyMotion> pieces;  ///< [motion::InitialState::pieces]
  double contact = 0.0;                    ///< energy stored in overlaps and bonds of friction, J
  double joint = 0.0;                      ///< energy stored in joints, J
  double work = 0.0;                       ///< done so far by pulses, winds, bows and driven groups, J
  double gravitational = 0.0;              ///< potential energy against the origin, J

  [[nodiscard]] double kinetic() const;  ///< energy of all bodies, J
  [[nodiscard]] double elastic() const;  ///< energy of all bodies, J
  /// Kinetic, elastic, contact, joint and gravitational energy, J; NaN where the motion is not finite.
  [[nodiscard]] double energy() const;
};

/// Appends the words of a sum to those that sum_over_ranks() adds up.
void append(std::vector<std::int64_t>& words, const ReproducibleSum& sum);

/// The sum whose words come first; takes them off.
[[nodiscard]] ReproducibleSum take_sum(std::span<const std::int64_t>& words);

/// The words of this rank's sums, to be added up over the ranks: an observation that is still in parts. No
/// communication.
/// @return [words_per_observation]
[[nodiscard]] std::vector<std::int64_t> observation_words(const Preparation& ready, motion::Motion& motion);

[[nodiscard]] std::size_t words_per_observation(const Preparation& ready);

/// Adds up the ranks' words of any number of observations, on rank 0; others get nothing. Collective.
/// @param words  [words_per_observation x observations], the same number on all ranks
[[nodiscard]] std::vector<std::int64_t> sum_over_ranks(const std::vector<std::int64_t>& words, MPI_Comm communicator);

/// Makes an observation of added words.
/// @param words  [words_per_observation]
[[nodiscard]] Observation observation(const Preparation& ready, std::span<const std::int64_t> words);

/// The bodies now, on rank 0; others get an empty one. Collective.
[[nodiscard]] Observation observe(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator);

}  // namespace idiophone::bodies
