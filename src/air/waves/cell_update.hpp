#pragma once
// What a step adds to the rates of a box of cells.

#include <span>
#include <vector>

#include "absorbing_layer.hpp"
#include "idiophone/air/waves/subdomain.hpp"

namespace idiophone::waves {

/// Open air and absorbing layers. Every cell is computed in the same way in any box.
class CellUpdate {
 public:
  /// @param cells    of the subdomain; along x whole pieces of rows
  /// @param courant  c dt/h
  CellUpdate(const Subdomain& subdomain, const CellBox& cells, float courant);

  [[nodiscard]] const CellBox& cells() const { return cells_; }

  /// Adds to the rates of the cells in one plane. To be called once in a step for each plane of the box in ascending
  /// order, as long as the pressures of this plane and of both its neighbours are those before the step.
  /// @param pressure  [subdomain.length()] Pa
  /// @param rate      likewise, Pa per step
  void add_rates(int z, std::span<const float> pressure, std::span<float> rate);

  /// The layers in the box.
  [[nodiscard]] std::vector<AbsorbingLayer>& layers() { return layers_; }

 private:
  Subdomain subdomain_;
  CellBox cells_;
  float square_;  // C^2
  std::vector<AbsorbingLayer> layers_;
};

/// Divides the cells of a subdomain into boxes: those at faces that neighbours wait for, and last all others.
[[nodiscard]] std::vector<CellBox> boxes_from_faces(const Subdomain& subdomain);

}  // namespace idiophone::waves
