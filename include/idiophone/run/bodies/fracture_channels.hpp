#pragma once
// How far each body that can break is broken, and what energy that took, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/motion_rate_channels.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class FractureChannels : public MotionRateChannels {
 public:
  /// @param motion  must outlive this object
  FractureChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator);

  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  void note_row() override;
  const motion::Motion& motion_;
  MPI_Comm communicator_;
  std::vector<double> rows_;  ///< [rows][bodies that can break][area, energy] m2, J
};

}  // namespace idiophone::bodies
