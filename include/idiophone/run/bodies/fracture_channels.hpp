#pragma once
// How far each body that can break is broken, and what energy that took, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class FractureChannels : public ChannelGroup {
 public:
  /// @param motion  must outlive this object
  FractureChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator);

  void note(std::int64_t sample) override;
  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  const motion::Motion& motion_;
  MPI_Comm communicator_;
  std::int64_t stride_;       ///< audio samples between rows; 0 for none
  std::vector<double> rows_;  ///< [rows][bodies that can break][area, energy] m2, J
};

}  // namespace idiophone::bodies
