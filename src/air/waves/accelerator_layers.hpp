#pragma once
// Absorbing layers on an accelerator.

#include <vector>

#include "absorbing_layer.hpp"
#include "idiophone/foundation/accelerator/array.hpp"

namespace idiophone::waves {

/// The memory of all layers of a subdomain, one after the other.
class AcceleratorLayers {
 public:
  AcceleratorLayers(accelerator::Accelerator& accelerator, const std::vector<AbsorbingLayer>& layers);

  /// @param layers  the same as at the beginning
  void save(std::vector<AbsorbingLayer>& layers) const;
  void load(std::vector<AbsorbingLayer>& layers);

 private:
  struct Tables {
    std::vector<LayerTable> layers;
    std::vector<float> decay;
    int faces = 0;           // of all layers
    std::size_t length = 0;  // of the memory
  };
  [[nodiscard]] static Tables make_tables(const std::vector<AbsorbingLayer>& layers);
  AcceleratorLayers(accelerator::Accelerator& accelerator, const Tables& tables);

 public:
  // For the kernels:
  int count, faces;
  accelerator::Array<LayerTable> tables;
  accelerator::Array<float> decay, face_memory, cell_memory;
};

}  // namespace idiophone::waves
