#include "idiophone/timbre/nodes/control.hpp"

#include <cmath>
#include <utility>

namespace idiophone::timbre {

namespace {

/// Time constants of the filters after which 99 % of a step are done: (1 + t) exp(-t) = 0.01.
constexpr double time_constants = 6.6384;

}  // namespace

ControlNode::ControlNode(std::shared_ptr<const Control> control, double smoothing, int rate)
    : control_(std::move(control)),
      share_(smoothing > 0.0 ? -std::expm1(-time_constants / (smoothing * rate)) : 1.0),
      first_(control_->value()),
      second_(first_) {}

void ControlNode::render(const Block& block, std::span<const Input> /*inputs*/, std::span<double> output) {
  const double target = control_->value();
  for (std::size_t i = 0; i < block.count; ++i) {
    first_ = without_denormals(first_ + share_ * (target - first_));
    second_ = without_denormals(second_ + share_ * (first_ - second_));
    output[i] = second_;
  }
}

}  // namespace idiophone::timbre
