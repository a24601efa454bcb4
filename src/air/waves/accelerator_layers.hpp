#pragma once
// Absorbing layers on an accelerator.

#include <utility>
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

  /// The memory of the faces is now that after the step.
  void advance() { std::swap(faces, next_faces); }

  // For the kernels:
  int count;
  int faces, next_faces, cells;  ///< places in the memory: of the faces before a step and after it, of the cells
  accelerator::Array<LayerTable> tables;
  accelerator::Array<float> decay, memory;

 private:
  struct Tables {
    std::vector<LayerTable> layers;
    std::vector<float> decay;
    std::size_t length = 0;  // of the memory of all faces, or of all cells
  };
  [[nodiscard]] static Tables make_tables(const std::vector<AbsorbingLayer>& layers);
  AcceleratorLayers(accelerator::Accelerator& accelerator, const Tables& tables);
};

}  // namespace idiophone::waves
