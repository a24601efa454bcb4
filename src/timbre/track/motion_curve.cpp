#include "motion_curve.hpp"

#include "idiophone/timbre/track/soundtrack.hpp"

namespace idiophone::timbre {

std::shared_ptr<const Curve> curve_of(const timbre::MotionVariable& variable, const MotionChannels& motion) {
  ChannelValues channel = motion.values(variable);
  std::vector<double> times(channel.values.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<double>(i) / channel.rate;
  }
  return std::make_shared<const Curve>(std::move(times), std::move(channel.values), variable.interpolation);
}

Bindings bindings_of(const std::vector<NamedVariable>& parameters, const MotionChannels& motion) {
  Bindings bindings;
  for (const NamedVariable& parameter : parameters) {
    Binding binding{.value = 0.0, .where = parameter.where};
    if (const auto* number = std::get_if<double>(&parameter.variable)) {
      binding.value = *number;
    } else if (const auto* keys = std::get_if<Keyframes>(&parameter.variable)) {
      binding.value = time_dependent_variable(*keys);
    } else if (const auto* channel = std::get_if<MotionVariable>(&parameter.variable)) {
      binding.value = curve_of(*channel, motion);
    }
    bindings[parameter.name] = std::move(binding);
  }
  return bindings;
}

}  // namespace idiophone::timbre
