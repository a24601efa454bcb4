#pragma once
// All that decides the future of a field, where the processor can read and change it.

#include <memory>
#include <span>
#include <vector>

#include "cell_update.hpp"
#include "face_exchange.hpp"
#include "idiophone/air/waves/cut_cells.hpp"
#include "wall_losses.hpp"

namespace idiophone::waves {

struct FieldState {
  /// Air at rest without surfaces.
  /// @param boxes    into which the cells of the subdomain are divided
  /// @param courant  c dt/h
  FieldState(const Subdomain& subdomain, const std::vector<CellBox>& boxes, float courant);

  Subdomain subdomain;
  float courant;
  CutCells cut_cells;
  std::unique_ptr<WallLosses> losses;  ///< none without surfaces, and if walls take nothing
  std::vector<CellUpdate> updates;     ///< of the boxes; they hold the memory of the absorbing layers
  std::vector<float> pressure;         ///< [cells, then nodes] Pa
  std::vector<float> rate;             ///< [cells] Pa per step
  std::vector<float> node_rate;        ///< [nodes] Pa per step

  [[nodiscard]] std::span<float> node_pressures() { return std::span(pressure).subspan(subdomain.length()); }

  /// Gives the cells with nodes the pressures of their first ones, and the cells below a rigid floor those of their
  /// mirror images. To be called when ghost cells and nodes have changed.
  void publish_nodes();
};

}  // namespace idiophone::waves
