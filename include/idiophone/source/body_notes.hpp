#pragma once
// The motion channels: each body's motion, and all energies, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/source/observation.hpp"
#include "idiophone/store/result_file.hpp"

namespace idiophone::source {

class BodyNotes {
 public:
  BodyNotes(const Preparation& ready, MPI_Comm communicator);

  /// Declares the series of a new result. Collective.
  void declare(store::ResultFile& result) const;

  /// Notes a row if one is due at an audio sample. No communication.
  void note(std::int64_t sample, motion::Motion& motion);

  /// Writes all rows noted since the last writing. Collective.
  void write(store::ResultFile& result);

  /// Orientations in the last row written, which decide the sign of the next ones; on rank 0, [4 x bodies], w x y z.
  [[nodiscard]] std::vector<double> save() const;
  /// Goes on from what `save` gave.
  void restore(std::span<const double> orientations);

 private:
  const Preparation& ready_;
  MPI_Comm communicator_;
  std::int64_t stride_;                           ///< audio samples between rows; 0 for none
  std::vector<std::int64_t> notes_;               ///< [words per observation x rows]
  std::vector<Eigen::Quaterniond> orientations_;  ///< [bodies] in the last row written
};

}  // namespace idiophone::source
