#include "accelerator_layers.hpp"

namespace idiophone::waves {

namespace {

/// Places of decays and of memory become those among all layers.
int append(const std::vector<float>& decay, std::vector<float>& all) {
  const int place = static_cast<int>(all.size());
  all.insert(all.end(), decay.begin(), decay.end());
  return place;
}

}  // namespace

AcceleratorLayers::Tables AcceleratorLayers::make_tables(const std::vector<AbsorbingLayer>& layers) {
  Tables all;
  for (const AbsorbingLayer& layer : layers) {
    LayerTable table = layer.table();
    table.face_decay += append(layer.face_decay(), all.decay);
    table.cell_decay += append(layer.cell_decay(), all.decay);
    table.memory += static_cast<int>(all.length);
    all.length += layer.memory_length();
    all.layers.push_back(table);
  }
  return all;
}

AcceleratorLayers::AcceleratorLayers(accelerator::Accelerator& accelerator, const std::vector<AbsorbingLayer>& layers)
    : AcceleratorLayers(accelerator, make_tables(layers)) {}

AcceleratorLayers::AcceleratorLayers(accelerator::Accelerator& accelerator, const Tables& made)
    : count(static_cast<int>(made.layers.size())),
      faces(0),
      next_faces(static_cast<int>(made.length)),
      cells(2 * next_faces),
      tables(accelerator, made.layers),
      decay(accelerator, made.decay),
      memory(accelerator, 3 * made.length) {}

void AcceleratorLayers::save(std::vector<AbsorbingLayer>& layers) const {
  std::size_t place = 0;
  for (AbsorbingLayer& layer : layers) {
    memory.read(layer.face_memory(), faces + place);
    memory.read(layer.cell_memory(), cells + place);
    place += layer.memory_length();
  }
}

void AcceleratorLayers::load(std::vector<AbsorbingLayer>& layers) {
  std::size_t place = 0;
  for (AbsorbingLayer& layer : layers) {
    memory.write(layer.face_memory(), faces + place);
    memory.write(layer.cell_memory(), cells + place);
    place += layer.memory_length();
  }
}

}  // namespace idiophone::waves
