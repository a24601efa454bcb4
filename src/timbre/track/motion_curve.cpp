#include "motion_curve.hpp"

namespace idiophone::timbre {

std::shared_ptr<const Curve> curve_of(const timbre::MotionVariable& variable, const MotionChannels& motion) {
  ChannelValues channel = motion.values(variable);
  std::vector<double> times(channel.values.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<double>(i) / channel.rate;
  }
  return std::make_shared<const Curve>(std::move(times), std::move(channel.values), variable.interpolation);
}

}  // namespace idiophone::timbre
