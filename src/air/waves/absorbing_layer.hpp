#pragma once
// A perfectly matched layer at one side of the grid: coordinates are stretched into the complex plane, so that waves
// of any direction enter without reflection and decay (Roden and Gedney 2000, in the second-order wave equation).

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/air/waves/subdomain.hpp"
#include "idiophone/foundation/parallel/archive_row.hpp"
#include "layer_table.hpp"

namespace idiophone::waves {

/// The cells of the layer at one end of an axis, in the whole grid.
[[nodiscard]] CellBox layer_cells(const Grid& grid, std::size_t axis, int end);

/// With d the loss per time, d/dx becomes d/dx + psi, psi a memory of d/dx that decays with d; twice, as the equation
/// has two derivatives. Cells and times are the units.
class AbsorbingLayer {
 public:
  /// @param cells    of the subdomain; this object computes those that are in the layer, at least one
  /// @param axis     0 to 2
  /// @param end      0: at the lower end of the axis, 1: at the upper one
  /// @param courant  c dt/h
  AbsorbingLayer(const Subdomain& subdomain, const CellBox& cells, std::size_t axis, int end, float courant);

  /// Adds to the rates of the cells in one plane what the stretched coordinates change, and advances its memory by a
  /// step. To be called for each plane of the cells in ascending order, as long as the pressures of this plane and of
  /// both its neighbours are those before the step.
  /// @param pressure  [subdomain.length()] Pa
  /// @param rate      likewise, Pa per step
  void add(int z, std::span<const float> pressure, std::span<float> rate);

  /// For an accelerator. Memories, decays and faces are counted from 0.
  [[nodiscard]] LayerTable table() const;
  /// What remains of the memory in a step, along the axis: of the faces and of the cells of table().
  [[nodiscard]] const std::vector<float>& face_decay() const { return face_decay_; }
  [[nodiscard]] const std::vector<float>& cell_decay() const { return cell_decay_; }
  /// How long each of both memories is.
  [[nodiscard]] std::size_t memory_length() const { return cell_memory_.size(); }
  [[nodiscard]] std::vector<float>& face_memory() { return face_memory_; }
  [[nodiscard]] std::vector<float>& cell_memory() { return cell_memory_; }

  /// How many rows of an archive all layers of a grid have: one for each piece of a row.
  [[nodiscard]] static std::int64_t archive_rows(const Grid& grid);
  /// The numbers of this object's rows among them.
  [[nodiscard]] std::vector<std::int32_t> row_numbers() const;
  /// The memory in one of its rows.
  /// @param place  in row_numbers()
  void archive(std::size_t place, parallel::ArchiveRow& row);

 private:
  template <class Visit>
  void for_each_row(const CellBox& box, int z, const Visit& visit) const;
  [[nodiscard]] Index place(const std::array<int, 3>& cell) const;
  void stretch_faces(int z, std::span<const float> pressure);
  void stretch_cells(int z, std::span<const float> pressure, std::span<float> rate);

  Subdomain subdomain_;
  std::size_t axis_;
  int end_;
  float square_;                                // C^2
  CellBox cells_;                               // of the layer
  CellBox faces_;                               // cells with the faces at their outer sides that these cells need
  std::array<Index, 3> strides_{};              // of the memory, which has an empty shell around the layer's cells
  Index outwards_ = 0, inwards_ = 0;            // to the next cell outwards, and to the next one inwards in the memory
  std::vector<float> face_decay_, cell_decay_;  // per step, by place along the axis in faces_ and cells_
  std::vector<float> face_memory_, cell_memory_;
};

}  // namespace idiophone::waves
