#pragma once
// Losses at walls on an accelerator.

#include "wall_losses.hpp"
#include "wave_kernels.hpp"

namespace idiophone::waves {

/// A half derivative of many quantities.
struct AcceleratorHalfDerivative {
  AcceleratorHalfDerivative(accelerator::Accelerator& accelerator, const HalfDerivative& from);
  void save(HalfDerivative& to) const;

  int quantities;
  float all_weights;
  accelerator::Array<float> weights, paces, ratios;
  accelerator::Array<float> past;  // [relaxations x quantities]
};

/// What WallLosses does, on an accelerator.
class AcceleratorLosses {
 public:
  /// @param cells  the length of an array of cells
  /// @param nodes  of the subdomain, without those of ghost cells
  AcceleratorLosses(WaveKernels& kernels, const WallLosses& losses, int cells, Index nodes);

  /// Whether the past advances by the step that is asked about.
  enum class Past : std::int32_t { stays, advances };

  /// @param pressure  [cells, then nodes] before the step
  /// @param rate      [nodes] what friction takes is taken from it
  /// @param change    [nodes] overwritten: the rate, less what heat takes
  void take(const accelerator::Array<float>& pressure, accelerator::Array<float>& rate,
            accelerator::Array<float>& change, Past past);

  /// @param losses  the same as at the beginning
  void save(WallLosses& losses) const;

 private:
  WaveKernels& kernels_;
  int cells_, nodes_, ways_;
  AcceleratorHalfDerivative friction_, heat_;
  accelerator::Array<Index> node_, other_;     // of the ways
  accelerator::Array<float> weight_, flow_;    // of the ways
  accelerator::Array<float> slowed_;           // of the ways
  accelerator::Array<Index> first_way_;        // of the nodes, and one more
  accelerator::Array<Index> place_in_cooled_;  // of the nodes; -1 for none
};

}  // namespace idiophone::waves
