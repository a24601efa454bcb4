#pragma once
// Absorbing layers on an accelerator.

#include <vector>

#include "absorbing_layer.hpp"
#include "wave_kernels.hpp"

namespace idiophone::waves {

/// The memory of all layers of a subdomain, one after the other.
class AcceleratorLayers {
 public:
  AcceleratorLayers(WaveKernels& kernels, const std::vector<AbsorbingLayer>& layers);

  /// Advances the faces, then the cells of the subdomain.
  /// @param square    C^2
  /// @param pressure  before the step
  /// @param next      after the step
  void step(const Subdomain& subdomain, float square, const accelerator::Array<float>& pressure,
            accelerator::Array<float>& rate, accelerator::Array<float>& next);

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
  [[nodiscard]] static Tables tables(const std::vector<AbsorbingLayer>& layers);
  AcceleratorLayers(WaveKernels& kernels, const Tables& tables);

  WaveKernels& kernels_;
  int count_, faces_;
  accelerator::Array<LayerTable> tables_;
  accelerator::Array<float> decay_, face_memory_, cell_memory_;
};

}  // namespace idiophone::waves
