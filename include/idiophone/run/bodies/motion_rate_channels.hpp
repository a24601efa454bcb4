#pragma once
// Channels that have a row at the motion rate (`output.motion_per_second`), not at every audio sample.

#include <cstdint>
#include <vector>

#include "idiophone/run/bodies/channel.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::bodies {

class MotionRateChannels : public ChannelGroup {
 public:
  /// Notes a row at the samples of the motion rate, and does nothing at others.
  void note(std::int64_t sample) final;

 protected:
  /// @param scene     its motion rate is the rate of all channels; if it is zero, there are no channels
  /// @param channels  their rates are set here
  MotionRateChannels(const scene::Scene& scene, std::vector<spectra::Series> channels);

 private:
  /// Notes one row of each channel. No communication.
  virtual void note_row() = 0;

  std::int64_t samples_per_row_;  ///< audio samples between two rows; 0 for no rows
};

}  // namespace idiophone::bodies
