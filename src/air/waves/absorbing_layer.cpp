#include "absorbing_layer.hpp"

#include <algorithm>
#include <cmath>

#include "step_formulas.hpp"

namespace idiophone::waves {

namespace {

/// Amplitude that a wave has left after it went through the layer and back.
constexpr double remainder = 1e-5;

/// What remains of the memory after a step, at a depth in a layer (both in cells): the loss grows with the square.
float decay(double depth, int layer, float courant) {
  const double largest = -1.5 * std::log(remainder) / layer;  // its integral over the layer is -log(remainder)/2
  return static_cast<float>(std::exp(-largest * std::pow(depth / layer, 2) * courant));
}

/// Cells from the inner edge of a layer to a place along its axis.
int depth_of(const Grid& grid, std::size_t axis, int end, int place) {
  return end == 0 ? grid.layer - 1 - place : place - (grid.cells.at(axis) - grid.layer);
}

float at(const float* decay, int i) {
  return decay[i];
}

float at(float decay, int /*i*/) {
  return decay;
}

/// Pressures of a row of cells along x, and of those next to them, Pa.
struct Pressures {
  const float* here;
  const float* outer;
  const float* inner = nullptr;
};

/// Memories at the outer and inner faces of the cells.
struct Faces {
  const float* outer;
  const float* inner;
};

// Vectors need to know that the memories and the rates do not overlap with anything else.

/// @param decay  per step: of each cell, or of all
template <class Decay>
void stretch_line_of_faces(int length, Decay decay, const Pressures& pressures, float* __restrict memory) {
  const auto [here, outer, inner] = pressures;
  for (int i = 0; i < length; ++i) {
    memory[i] = memory_of_face(at(decay, i), memory[i], here[i], outer[i]);
  }
}

/// @param square  C^2
template <class Decay>
void stretch_line_of_cells(int length, Decay decay, const Pressures& pressures, const Faces& faces, float square,
                           float* __restrict memory, float* __restrict rate) {
  const auto [here, outer, inner] = pressures;
  const auto [outer_faces, inner_faces] = faces;
  for (int i = 0; i < length; ++i) {
    const float stretched = outer_faces[i] - inner_faces[i];
    memory[i] = memory_of_cell(at(decay, i), memory[i], inflow_along(here[i], outer[i], inner[i]), stretched);
    rate[i] += square * (stretched + memory[i]);
  }
}

/// Calls stretch() with the decay in a row of cells: of each, or of all.
template <class Stretch>
void with_decay(const std::vector<float>& decay, std::size_t axis, int place, const Stretch& stretch) {
  if (axis == 0) {
    stretch(decay.data());
  } else {
    stretch(decay[place]);
  }
}

/// Rows of an archive of the layers before this one.
std::int64_t rows_before(const Grid& grid, std::size_t axis, int end) {
  std::int64_t rows = 0;
  for (std::size_t layer = 0; layer < 2 * axis + end; ++layer) {
    const CellBox cells = layer_cells(grid, layer / 2, static_cast<int>(layer % 2));
    rows += cells.is_empty() ? 0 : static_cast<std::int64_t>(row_pieces(cells).size());
  }
  return rows;
}

}  // namespace

CellBox layer_cells(const Grid& grid, std::size_t axis, int end) {
  CellBox cells = grid.all();
  if (end == 0) {
    cells.to.at(axis) = grid.layer_at(axis, end);
  } else {
    cells.from.at(axis) = grid.cells.at(axis) - grid.layer_at(axis, end);
  }
  return common(cells, grid.all());
}

AbsorbingLayer::AbsorbingLayer(const Subdomain& subdomain, const CellBox& cells, std::size_t axis, int end,
                               float courant)
    : subdomain_(subdomain), axis_(axis), end_(end), square_(courant * courant) {
  const Grid& grid = subdomain.grid();
  const CellBox layer = layer_cells(grid, axis, end);
  cells_ = common(cells, layer);
  faces_ = cells_;
  end == 0 ? ++faces_.to.at(axis) : --faces_.from.at(axis);  // those at the inner sides, too
  faces_ = common(faces_, layer);
  strides_ = {1, cells_.width(0) + 2, (cells_.width(0) + 2) * (cells_.width(1) + 2)};
  const auto length = static_cast<std::size_t>(strides_[2]) * (cells_.width(2) + 2);
  face_memory_.resize(length);
  cell_memory_.resize(length);
  const int direction = end == 0 ? -1 : 1;
  outwards_ = direction * subdomain.stride(axis);
  inwards_ = -direction * strides_.at(axis);
  for (int place = faces_.from.at(axis); place < faces_.to.at(axis); ++place) {
    face_decay_.push_back(decay(depth_of(grid, axis, end, place) + 1.0, grid.layer, courant));
  }
  for (int place = cells_.from.at(axis); place < cells_.to.at(axis); ++place) {
    cell_decay_.push_back(decay(depth_of(grid, axis, end, place) + 0.5, grid.layer, courant));
  }
}

Index AbsorbingLayer::place(const std::array<int, 3>& cell) const {
  return (cell[2] - cells_.from[2] + 1) * strides_[2] + (cell[1] - cells_.from[1] + 1) * strides_[1] +
         (cell[0] - cells_.from[0] + 1);
}

/// Calls visit(first cell, its place along the axis in the box) for the rows of a plane.
template <class Visit>
void AbsorbingLayer::for_each_row(const CellBox& box, int z, const Visit& visit) const {
  for (int y = box.from[1]; y < box.to[1]; ++y) {
    const std::array<int, 3> first = {box.from[0], y, z};
    visit(first, first.at(axis_) - box.from.at(axis_));
  }
}

void AbsorbingLayer::stretch_faces(int z, std::span<const float> pressure) {
  for_each_row(faces_, z, [&](const std::array<int, 3>& first, int along) {
    const float* const here = &pressure[subdomain_.number(first)];
    with_decay(face_decay_, axis_, along, [&](auto decay) {
      stretch_line_of_faces(faces_.width(0), decay, {here, here + outwards_}, &face_memory_[place(first)]);
    });
  });
}

void AbsorbingLayer::stretch_cells(int z, std::span<const float> pressure, std::span<float> rate) {
  for_each_row(cells_, z, [&](const std::array<int, 3>& first, int along) {
    const Index cell = subdomain_.number(first);
    const float* const here = &pressure[cell];
    const float* const faces = &face_memory_[place(first)];
    with_decay(cell_decay_, axis_, along, [&](auto decay) {
      stretch_line_of_cells(cells_.width(0), decay, {here, here + outwards_, here - outwards_},
                            {faces, faces + inwards_}, square_, &cell_memory_[place(first)], &rate[cell]);
    });
  });
}

void AbsorbingLayer::add(int z, std::span<const float> pressure, std::span<float> rate) {
  if (z < cells_.from[2] || z >= cells_.to[2]) {
    return;
  }
  // Cells need the faces at their inner side, too: those of the next plane, or of one before the first.
  const int last = axis_ == 2 && end_ == 0 ? z + 1 : z;
  const int first = z == cells_.from[2] ? faces_.from[2] : last;
  for (int plane = first; plane <= last && plane < faces_.to[2]; ++plane) {
    stretch_faces(plane, pressure);
  }
  stretch_cells(z, pressure, rate);
}

LayerTable AbsorbingLayer::table() const {
  const std::array<int, 3>& origin = subdomain_.cells().from;
  LayerTable table{};
  table.axis = static_cast<int>(axis_);
  table.outwards = outwards_;
  table.inwards = inwards_;
  table.inner = end_ == 0 ? 1 : -1;
  table.row = strides_[1];
  table.plane = strides_[2];
  table.memory = place(origin);
  table.face_decay = origin.at(axis_) - faces_.from.at(axis_);
  table.cell_decay = origin.at(axis_) - cells_.from.at(axis_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    table.from[axis] = cells_.from.at(axis) - origin.at(axis);
    table.to[axis] = cells_.to.at(axis) - origin.at(axis);
  }
  table.faces_from = faces_.from.at(axis_) - origin.at(axis_);
  table.faces_to = faces_.to.at(axis_) - origin.at(axis_);
  return table;
}

std::int64_t AbsorbingLayer::archive_rows(const Grid& grid) {
  return rows_before(grid, 3, 0);
}

std::vector<std::int32_t> AbsorbingLayer::row_numbers() const {
  const CellBox all = row_pieces(layer_cells(subdomain_.grid(), axis_, end_));
  const std::int64_t before = rows_before(subdomain_.grid(), axis_, end_);
  std::vector<std::int32_t> numbers;
  for_each_cell(row_pieces(cells_), [&](const std::array<int, 3>& piece) {
    numbers.push_back(static_cast<std::int32_t>(before + static_cast<std::int64_t>(all.place(piece))));
  });
  return numbers;
}

void AbsorbingLayer::archive(std::size_t place_of_piece, parallel::ArchiveRow& row) {
  std::array<int, 3> cell = row_pieces(cells_).cell(place_of_piece);
  const int begin = cell[0] * Grid::row_multiple;
  for (cell[0] = begin; cell[0] < begin + Grid::row_multiple; ++cell[0]) {
    float outside = 0.0F;
    const bool is_inside = cells_.contains(cell);
    const Index memory = is_inside ? place(cell) : 0;
    row.value(is_inside ? cell_memory_[memory] : outside);
    row.value(is_inside ? face_memory_[memory] : outside);
    row.value(is_inside ? face_memory_[memory + inwards_] : outside);  // it may belong to another object
  }
}

}  // namespace idiophone::waves
