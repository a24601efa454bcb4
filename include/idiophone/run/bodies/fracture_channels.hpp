#pragma once
// How far each body that can break is broken, what energy that took, and which of its pieces still hang together, at
// the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/motion_rate_channels.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class FractureChannels : public MotionRateChannels {
 public:
  /// @param motion  must outlive this object
  FractureChannels(const Preparation& ready, const motion::Motion& motion, MPI_Comm communicator);

  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  void note_row() override;
  const motion::Motion& motion_;
  MPI_Comm communicator_;
  std::vector<double> values_;  ///< [rows][channels][columns]; zeros but on the rank that owns the surfaces
};

}  // namespace idiophone::bodies
