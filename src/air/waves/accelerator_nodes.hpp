#pragma once
// Nodes at surfaces on an accelerator.

#include <optional>

#include "accelerator_losses.hpp"
#include "field_state.hpp"
#include "node_table.hpp"

namespace idiophone::waves {

/// As long as the surfaces of a field stay where they are.
class AcceleratorNodes {
 public:
  AcceleratorNodes(WaveKernels& kernels, const FieldState& state);

  [[nodiscard]] Index own() const { return nodes_; }
  /// Whether walls take something in each step.
  [[nodiscard]] bool is_lossy() const { return losses_.has_value(); }
  /// What walls take in a step, after which the nodes get their new pressures.
  /// @param pressure  [cells, then nodes] before the step
  /// @param next      after the step; the cells with nodes get the pressures of their first ones
  void take_losses(const accelerator::Array<float>& pressure, accelerator::Array<float>& next);
  /// As WaveField::forecast().
  void forecast(const accelerator::Array<float>& pressure, std::span<float> pressures);
  /// @param state  with the surfaces of the beginning
  void save(FieldState& state) const;

  // For the kernels:
  accelerator::Array<NodeTable> tables;
  accelerator::Array<Link> links;
  accelerator::Array<float> rate;          ///< [nodes]
  accelerator::Array<unsigned char> held;  ///< whether a cell has the pressure of a node, or is solid: [cells]

 private:
  [[nodiscard]] accelerator::Range range() const { return {static_cast<std::size_t>(nodes_), 1, 1}; }

  WaveKernels& kernels_;
  int cells_, nodes_;                            // length of an array of cells; nodes of the subdomain
  accelerator::Array<float> change_, forecast_;  // [nodes]
  std::optional<AcceleratorLosses> losses_;
};

}  // namespace idiophone::waves
