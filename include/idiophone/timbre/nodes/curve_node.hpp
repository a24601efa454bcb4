#pragma once
// A curve as a node: keyframes in a tree, or what a parameter is bound to.

#include <memory>
#include <string>

#include "idiophone/timbre/nodes/curve.hpp"
#include "idiophone/timbre/nodes/sound_node.hpp"

namespace idiophone::timbre {

class CurveNode : public Node {
 public:
  /// @param start  of the sound, in the time of the curve, s
  CurveNode(std::shared_ptr<const Curve> curve, double start, int rate)
      : curve_(std::move(curve)), start_(start), rate_(rate) {}

  void render(const Block& block, std::span<const Input> /*inputs*/, std::span<double> output) override {
    for (std::size_t i = 0; i < block.count; ++i) {
      output[i] = curve_->at(start_ + static_cast<double>(block.first + static_cast<std::int64_t>(i)) / rate_);
    }
  }

 private:
  std::shared_ptr<const Curve> curve_;
  double start_;
  double rate_;
};

/// Finds linear, cubic and hold; false for any other word.
[[nodiscard]] bool find_interpolation(const std::string& word, Interpolation& interpolation);

}  // namespace idiophone::timbre
