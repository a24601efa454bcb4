#pragma once
// The total forces of winds and bows, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/motion_rate_channels.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class LoadChannels : public MotionRateChannels {
 public:
  /// @param motion  must outlive this object
  LoadChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator);

  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  void note_row() override;
  const motion::Motion& motion_;
  MPI_Comm communicator_;
  std::vector<std::int64_t> words_;  ///< [rows][winds, then bows][components] of reproducible sums
};

}  // namespace idiophone::bodies
