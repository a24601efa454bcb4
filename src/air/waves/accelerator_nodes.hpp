#pragma once
// Nodes at surfaces on an accelerator.

#include <optional>

#include "accelerator_layers.hpp"
#include "accelerator_losses.hpp"
#include "field_state.hpp"

namespace idiophone::waves {

/// Where the cells of a subdomain are in its arrays: the first one, and the lengths of rows and planes.
struct CellPlaces {
  Index first, row, plane;
};

/// As long as the surfaces of a field stay where they are.
class AcceleratorNodes {
 public:
  AcceleratorNodes(WaveKernels& kernels, const FieldState& state);

  [[nodiscard]] Index own() const { return nodes_; }
  /// Advances the nodes, and the memory of the layers' faces.
  /// @param place     of the first node in `sources`
  /// @param sources   what surfaces add to the rates of the nodes, Pa per step
  /// @param pressure  [cells, then nodes] before the step
  /// @param next      after the step; the cells with nodes get the pressures of their first ones
  void step(const CellPlaces& places, AcceleratorLayers& layers, int place, const accelerator::Array<float>& sources,
            const accelerator::Array<float>& pressure, accelerator::Array<float>& next);
  /// As WaveField::forecast().
  void forecast(const accelerator::Array<float>& pressure, std::span<float> pressures);
  /// Whether a cell has the pressure of a node, or is solid: [cells]. step() leaves out the solids, which keep 0.
  [[nodiscard]] const accelerator::Array<unsigned char>& held() const { return held_; }

  /// @param state  with the surfaces of the beginning
  void save(FieldState& state) const;

 private:
  [[nodiscard]] accelerator::Range range() const { return {static_cast<std::size_t>(nodes_), 1, 1}; }

  WaveKernels& kernels_;
  int cells_, nodes_;  // length of an array of cells; nodes of the subdomain
  accelerator::Array<Index> first_link_, to_;
  accelerator::Array<float> area_, stiffness_;
  accelerator::Array<float> rate_, change_, forecast_;  // [nodes]
  accelerator::Array<Index> published_;                 // [nodes] the cell that takes its pressure; -1 for none
  accelerator::Array<unsigned char> held_;
  std::optional<AcceleratorLosses> losses_;
};

}  // namespace idiophone::waves
