#pragma once
// The motion channels of each contact, at the audio rate: means over each audio sample, so that no impulse is lost.

#include <mpi.h>

#include <vector>

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

class ContactChannels : public ChannelGroup {
 public:
  /// @param motion  must outlive this object
  ContactChannels(const scene::Scene& scene, motion::Motion& motion, MPI_Comm communicator);

  /// Notes the mean since the last audio sample; sample 0 has none.
  void note(std::int64_t sample) override;
  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  motion::Motion& motion_;
  MPI_Comm communicator_;
  std::vector<std::vector<double>> rows_;  ///< [contacts][width x rows]; zeros but on the rank that reports it
};

}  // namespace idiophone::bodies
