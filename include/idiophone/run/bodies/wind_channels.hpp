#pragma once
// The total force of each wind, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class WindChannels : public ChannelGroup {
 public:
  /// @param motion  must outlive this object
  WindChannels(const scene::Scene& scene, const motion::Motion& motion, MPI_Comm communicator);

  void note(std::int64_t sample) override;
  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  const motion::Motion& motion_;
  MPI_Comm communicator_;
  std::int64_t stride_;              ///< audio samples between rows; 0 for none
  std::vector<std::int64_t> words_;  ///< [rows][winds][components] of reproducible sums
};

}  // namespace idiophone::bodies
