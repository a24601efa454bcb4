#include "absorbing_layer.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::waves {

namespace {

/// Amplitude that a wave has left after it went through the layer and back.
constexpr double remainder = 1e-5;

/// What remains of the memory after a step, at a depth in a layer (both in cells): the loss grows with the square.
float decay(double depth, int layer, float courant) {
  const double largest = -1.5 * std::log(remainder) / layer;  // its integral over the layer is -log(remainder)/2
  return static_cast<float>(std::exp(-largest * std::pow(depth / layer, 2) * courant));
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
    const float kept = at(decay, i);
    memory[i] = kept * memory[i] + (kept - 1.0F) * (outer[i] - here[i]);
  }
}

/// @param square  C^2
template <class Decay>
void stretch_line_of_cells(int length, Decay decay, const Pressures& pressures, const Faces& faces, float square,
                           float* __restrict memory, float* __restrict rate) {
  const auto [here, outer, inner] = pressures;
  const auto [outer_faces, inner_faces] = faces;
  for (int i = 0; i < length; ++i) {
    const float kept = at(decay, i);
    const float stretched = outer_faces[i] - inner_faces[i];
    const float plain = (outer[i] - here[i]) + (inner[i] - here[i]);
    memory[i] = kept * memory[i] + (kept - 1.0F) * (plain + stretched);
    rate[i] += square * (stretched + memory[i]);
  }
}

}  // namespace

AbsorbingLayer::AbsorbingLayer(const Slab& slab, std::size_t axis, int end, float courant)
    : slab_(slab), axis_(axis), end_(end), courant_(courant), from_{0, 0, slab.begin()}, to_(slab.grid().cells) {
  const int layer = slab.grid().layer_at(axis, end);
  to_[2] = slab.end();
  if (end == 0) {
    to_.at(axis) = std::min(to_.at(axis), layer);
  } else {
    from_.at(axis) = std::max(from_.at(axis), slab.grid().cells.at(axis) - layer);
  }
  for (std::size_t other = 0; other < 3; ++other) {
    to_.at(other) = std::max(from_.at(other), to_.at(other));
  }
  strides_ = {1, to_[0] - from_[0] + 2, (to_[0] - from_[0] + 2) * (to_[1] - from_[1] + 2)};
  const auto length = static_cast<std::size_t>(strides_[2]) * (to_[2] - from_[2] + 2);
  face_memory_.resize(length);
  cell_memory_.resize(length);
  const int direction = end == 0 ? -1 : 1;
  outwards_ = direction * slab.stride(axis);
  inwards_ = -direction * strides_.at(axis);
  for (int i = 0; i < layer; ++i) {
    const int depth = axis == 0 && end == 0 ? layer - 1 - i : i;
    face_decay_.push_back(decay(depth + 1.0, layer, courant));
    cell_decay_.push_back(decay(depth + 0.5, layer, courant));
  }
}

Index AbsorbingLayer::place(int x, int y, int z) const {
  return (z - from_[2] + 1) * strides_[2] + (y - from_[1] + 1) * strides_[1] + (x - from_[0] + 1);
}

int AbsorbingLayer::depth_of(int position) const {
  const auto& grid = slab_.grid();
  return end_ == 0 ? grid.layer - 1 - position : position - (grid.cells.at(axis_) - grid.layer);
}

template <class Visit>
void AbsorbingLayer::for_each_row(int z, const Visit& visit) const {
  for (int y = from_[1]; y < to_[1]; ++y) {
    const int depth = axis_ == 0 ? 0 : depth_of(axis_ == 1 ? y : z);
    visit(Row{slab_.number(from_[0], y, z), place(from_[0], y, z), depth});
  }
}

template <class Stretch>
void AbsorbingLayer::with_decay(const std::vector<float>& decay, const Row& row, const Stretch& stretch) const {
  if (axis_ == 0) {
    stretch(decay.data());
  } else {
    stretch(decay[row.depth]);
  }
}

void AbsorbingLayer::stretch_faces(const Row& row, std::span<const float> pressure) {
  const float* const here = &pressure[row.cell];
  with_decay(face_decay_, row, [&](auto decay) {
    stretch_line_of_faces(to_[0] - from_[0], decay, {here, here + outwards_}, &face_memory_[row.memory]);
  });
}

void AbsorbingLayer::stretch_cells(const Row& row, std::span<const float> pressure, std::span<float> rate) {
  const float* const here = &pressure[row.cell];
  const float* const faces = &face_memory_[row.memory];
  with_decay(cell_decay_, row, [&](auto decay) {
    stretch_line_of_cells(to_[0] - from_[0], decay, {here, here + outwards_, here - outwards_},
                          {faces, faces + inwards_}, courant_ * courant_, &cell_memory_[row.memory], &rate[row.cell]);
  });
}

void AbsorbingLayer::add(int z, std::span<const float> pressure, std::span<float> rate) {
  if (z < from_[2] || z >= to_[2]) {
    return;
  }
  const auto stretch_plane = [&](int plane) {
    if (axis_ != 2 || depth_of(plane) >= 0) {
      for_each_row(plane, [&](const Row& row) { stretch_faces(row, pressure); });
    }
  };
  // Cells need the faces at their inner side, too: those of the next plane, or of one before the first.
  const bool above = axis_ == 2 && end_ == 0;
  if (z == from_[2] && axis_ == 2) {
    stretch_plane(above ? z : z - 1);
  }
  stretch_plane(above ? z + 1 : z);
  for_each_row(z, [&](const Row& row) { stretch_cells(row, pressure, rate); });
}

void AbsorbingLayer::archive(int z, parallel::ArchiveRow& row) {
  const bool here = z >= from_[2] && z < to_[2];
  float unused = 0.0F;
  for (int y = from_[1]; y < to_[1]; ++y) {
    for (int x = from_[0]; x < to_[0]; ++x) {
      const Index memory = here ? place(x, y, z) : 0;
      row.value(here ? face_memory_[memory] : unused);
      row.value(here ? cell_memory_[memory] : unused);
      if (axis_ == 2) {  // the inner plane may belong to a neighbour
        row.value(here ? face_memory_[memory + inwards_] : unused);
      }
    }
  }
}

}  // namespace idiophone::waves
