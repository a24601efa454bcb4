#include "accelerator_layers.hpp"

namespace idiophone::waves {

namespace {

int faces_of(const LayerTable& layer) {
  int faces = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    faces *= layer.faces_to[axis] - layer.faces_from[axis];
  }
  return faces;
}

/// Places of decays and of memory become those among all layers.
int append(const std::vector<float>& decay, std::vector<float>& all) {
  const int place = static_cast<int>(all.size());
  all.insert(all.end(), decay.begin(), decay.end());
  return place;
}

}  // namespace

AcceleratorLayers::Tables AcceleratorLayers::tables(const std::vector<AbsorbingLayer>& layers) {
  Tables all;
  for (const AbsorbingLayer& layer : layers) {
    LayerTable table = layer.table();
    table.face_decay += append(layer.face_decay(), all.decay);
    table.cell_decay += append(layer.cell_decay(), all.decay);
    table.memory += static_cast<int>(all.length);
    table.first_face = all.faces;
    all.length += layer.memory_length();
    all.faces += faces_of(table);
    all.layers.push_back(table);
  }
  return all;
}

AcceleratorLayers::AcceleratorLayers(WaveKernels& kernels, const std::vector<AbsorbingLayer>& layers)
    : AcceleratorLayers(kernels, tables(layers)) {}

AcceleratorLayers::AcceleratorLayers(WaveKernels& kernels, const Tables& tables)
    : kernels_(kernels),
      count_(static_cast<int>(tables.layers.size())),
      faces_(tables.faces),
      tables_(kernels.program.accelerator(), tables.layers),
      decay_(kernels.program.accelerator(), tables.decay),
      face_memory_(kernels.program.accelerator(), tables.length),
      cell_memory_(kernels.program.accelerator(), tables.length) {}

void AcceleratorLayers::step(const Subdomain& subdomain, float square, const accelerator::Array<float>& pressure,
                             accelerator::Array<float>& rate, accelerator::Array<float>& next) {
  const CellBox& cells = subdomain.cells();
  const Index first = subdomain.number(cells.from), row = subdomain.stride(1), plane = subdomain.stride(2);
  kernels_.stretch_faces({static_cast<std::size_t>(faces_), 1, 1}, faces_, count_, tables_, first, row, plane, decay_,
                         pressure, face_memory_);
  const int width = cells.width(0), height = cells.width(1), depth = cells.width(2);
  kernels_.step_cells(
      {static_cast<std::size_t>(width), static_cast<std::size_t>(height), static_cast<std::size_t>(depth)}, width,
      height, depth, count_, tables_, first, row, plane, square, decay_, face_memory_, cell_memory_, pressure, rate,
      next);
}

void AcceleratorLayers::save(std::vector<AbsorbingLayer>& layers) const {
  std::size_t place = 0;
  for (AbsorbingLayer& layer : layers) {
    face_memory_.read(layer.face_memory(), place);
    cell_memory_.read(layer.cell_memory(), place);
    place += layer.memory_length();
  }
}

void AcceleratorLayers::load(std::vector<AbsorbingLayer>& layers) {
  std::size_t place = 0;
  for (AbsorbingLayer& layer : layers) {
    face_memory_.write(layer.face_memory(), place);
    cell_memory_.write(layer.cell_memory(), place);
    place += layer.memory_length();
  }
}

}  // namespace idiophone::waves
