#pragma once
// A perfectly matched layer at one side of the grid: coordinates are stretched into the complex plane, so that waves
// of any direction enter without reflection and decay (Roden and Gedney 2000, in the second-order wave equation).

#include <span>
#include <vector>

#include "idiophone/air/waves/grid.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::waves {

/// With d the loss per time, d/dx becomes d/dx + psi, psi a memory of d/dx that decays with d; twice, as the equation
/// has two derivatives. Cells and times are the units.
class AbsorbingLayer {
 public:
  /// @param axis     0 to 2
  /// @param end      0: at the lower end of the axis, 1: at the upper one
  /// @param courant  c dt/h
  AbsorbingLayer(const Slab& slab, std::size_t axis, int end, float courant);

  /// Adds to the rates of one plane what the stretched coordinates change, and advances its memory by a step. To be
  /// called for each of the slab's planes in ascending order, as long as the pressures of this plane and of both its
  /// neighbours are those before the step.
  /// @param pressure  [slab.length()] Pa
  /// @param rate      likewise, Pa per step
  void add(int z, std::span<const float> pressure, std::span<float> rate);

  /// The memory of one of the slab's planes; a row is as long in every plane.
  void archive(int z, parallel::ArchiveRow& row);

 private:
  /// One row of cells along x: places in arrays of cells, and in those of this layer.
  struct Row {
    Index cell, memory;
    int depth;  ///< cells from the inner edge of the layer; along x, that of the first cell
  };
  template <class Visit>
  void for_each_row(int z, const Visit& visit) const;
  [[nodiscard]] Index place(int x, int y, int z) const;
  [[nodiscard]] int depth_of(int position) const;
  template <class Stretch>
  void with_decay(const std::vector<float>& decay, const Row& row, const Stretch& stretch) const;
  void stretch_faces(const Row& row, std::span<const float> pressure);
  void stretch_cells(const Row& row, std::span<const float> pressure, std::span<float> rate);

  Slab slab_;
  std::size_t axis_;
  int end_;
  float courant_;
  std::array<int, 3> from_{}, to_{};            // cells of the layer on this rank
  std::array<Index, 3> strides_{};              // of the memory, which has an empty shell around the layer's cells
  Index outwards_ = 0, inwards_ = 0;            // to the next cell outwards, and to the next one inwards in the memory
  std::vector<float> face_decay_, cell_decay_;  // per step, [depth]; along x, [cell of a row]
  std::vector<float> face_memory_, cell_memory_;
};

}  // namespace idiophone::waves
