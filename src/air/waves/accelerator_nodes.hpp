#pragma once
// Nodes at surfaces on an accelerator.

#include <optional>

#include "accelerator_losses.hpp"
#include "field_state.hpp"

namespace idiophone::waves {

/// As long as the surfaces of a field stay where they are.
class AcceleratorNodes {
 public:
  AcceleratorNodes(WaveKernels& kernels, const FieldState& state);

  /// Advances the nodes; their cells remain to be published.
  /// @param pressure  [cells, then nodes] before the step
  /// @param next      after the step
  void step(std::span<const float> sources, const accelerator::Array<float>& pressure, accelerator::Array<float>& next);
  /// As WaveField::forecast().
  void forecast(const accelerator::Array<float>& pressure, std::span<float> pressures);
  /// Gives the cells with nodes the pressures of their first ones.
  void publish(accelerator::Array<float>& pressure, accelerator::Array<float>& cell_rate);

  /// @param state  with the surfaces of the beginning
  void save(FieldState& state) const;

 private:
  /// Cells that take the pressure of a node, or none.
  struct Published {
    std::vector<Index> cells, nodes;
  };
  [[nodiscard]] static Published published(const FieldState& state);
  AcceleratorNodes(WaveKernels& kernels, const FieldState& state, const Published& published);
  /// What the nodes change in a step. The rates, losses taken, go to `gain`.
  [[nodiscard]] const accelerator::Array<float>& changes(const accelerator::Array<float>& pressure,
                                                         const accelerator::Array<float>& sources,
                                                         accelerator::Array<float>& gain, AcceleratorLosses::Past past);

  WaveKernels& kernels_;
  int cells_, nodes_;  // length of an array of cells; nodes of the subdomain
  accelerator::Array<Index> first_link_, to_;
  accelerator::Array<float> area_, stiffness_;
  accelerator::Array<float> rate_, sources_, no_sources_, change_, forecast_;  // [nodes]
  accelerator::Array<Index> published_cells_, published_nodes_;
  std::optional<AcceleratorLosses> losses_;
};

}  // namespace idiophone::waves
