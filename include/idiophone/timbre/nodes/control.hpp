#pragma once
// A number that a program sets while a sound plays.

#include <atomic>
#include <memory>

#include "idiophone/timbre/nodes/sound_node.hpp"

namespace idiophone::timbre {

/// One thread may set it while another renders the sound.
class Control {
 public:
  explicit Control(double value) : value_(value) {}

  void set(double value) { value_.store(value, std::memory_order_relaxed); }
  [[nodiscard]] double value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<double> value_;
};

/// The control as a signal without clicks: two low-pass filters of first order in a row. Neither the signal nor its
/// slope jumps, and it never overshoots. It begins at the value that the control then has.
class ControlNode : public Node {
 public:
  /// @param smoothing  time after which 99 % of a change are done, s; 0: at once
  ControlNode(std::shared_ptr<const Control> control, double smoothing, int rate);

  /// The control is read once, at the beginning of the block.
  void render(const Block& block, std::span<const Input> inputs, std::span<double> output) override;

 private:
  std::shared_ptr<const Control> control_;
  double share_;  // of what is left, that each filter does in a sample
  double first_, second_;
};

}  // namespace idiophone::timbre
