#pragma once
// A node of a timbre tree while it sounds: from the samples of its arguments to samples of its own.

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace idiophone::timbre {

/// The samples that a node computes at once.
struct Block {
  std::int64_t first = 0;  ///< since the sound began
  std::size_t count = 0;
  std::size_t width = 1;  ///< components of the node: 1, or the length of its vector
};

/// An argument of a node: a constant, or samples of another node. One component serves all components of the node.
struct Input {
  const double* values = nullptr;
  std::size_t sample_stride = 0;     ///< 0 for a constant
  std::size_t component_stride = 0;  ///< 0 for one component

  [[nodiscard]] double at(std::size_t sample, std::size_t component) const {
    return values[sample * sample_stride + component * component_stride];
  }
};

class Node {
 public:
  Node() = default;
  virtual ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  Node(Node&&) = delete;
  Node& operator=(Node&&) = delete;

  /// Blocks come one after another without gap, of any length; the samples do not depend on how they are divided.
  /// @param output  [width x count] a sample's components side by side
  virtual void render(const Block& block, std::span<const Input> inputs, std::span<double> output) = 0;
};

/// Which sample, of which component.
struct Moment {
  std::int64_t sample;  ///< since the sound began
  std::size_t component;
};

/// A node whose components are independent: each has a state with `step(Moment, const Arguments&)`, where Arguments is
/// a std::array of its first arguments.
template <class State>
class ComponentNode : public Node {
 public:
  /// @param states  [width]
  explicit ComponentNode(std::vector<State> states) : states_(std::move(states)) {}

  void render(const Block& block, std::span<const Input> inputs, std::span<double> output) override {
    typename State::Arguments arguments{};
    for (std::size_t i = 0; i < block.count; ++i) {
      for (std::size_t c = 0; c < block.width; ++c) {
        for (std::size_t a = 0; a < arguments.size(); ++a) {
          arguments[a] = inputs[a].at(i, c);
        }
        output[i * block.width + c] = states_[c].step(Moment{block.first + static_cast<std::int64_t>(i), c}, arguments);
      }
    }
  }

 private:
  std::vector<State> states_;
};

/// Numbers this small are set to zero in every node with feedback, so that none becomes denormal: 600 dB below 1.
[[nodiscard]] inline double without_denormals(double number) {
  constexpr double smallest = 1e-30;
  return std::abs(number) < smallest ? 0.0 : number;
}

}  // namespace idiophone::timbre
