#pragma once
// The motion channels of each contact, at audio rate: means over each audio sample, so that no impulse is lost.

#include <mpi.h>

#include <vector>

#include "idiophone/motion/motion.hpp"
#include "idiophone/source/preparation.hpp"
#include "idiophone/store/result_file.hpp"

namespace idiophone::source {

class ContactNotes {
 public:
  ContactNotes(const Preparation& ready, MPI_Comm communicator);

  /// Declares the series of a new result. Collective.
  void declare(store::ResultFile& result) const;

  /// Notes the mean since the last audio sample; sample 0 has none. No communication.
  void note(std::int64_t sample, motion::Motion& motion);

  /// Writes all rows noted since the last writing. Collective.
  void write(store::ResultFile& result);

 private:
  const Preparation& ready_;
  MPI_Comm communicator_;
  std::vector<std::vector<double>> notes_;  ///< [contacts][width x rows] of the contacts that this rank speaks for
};

}  // namespace idiophone::source
