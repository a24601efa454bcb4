#pragma once
// A surface whose vertices are moved by an accelerator: reads and low-pass are computed there.

#include <array>
#include <vector>

#include "idiophone/air/surface/surface.hpp"
#include "idiophone/foundation/accelerator/background_read.hpp"
#include "idiophone/foundation/accelerator/kernel.hpp"

namespace idiophone::surface {

/// Does what Surface does, to rounding. An audio sample has reads_per_sample() reads, each after displace() of all
/// vertices; take() follows. Only what take() returns leaves the accelerator. All triangles are open.
class AcceleratedSurface {
 public:
  /// @param accelerator  must outlive this object, as must the surface
  /// @param triangles    of the surface, as it was given them
  /// @param surface      begins or is restored between two audio samples; load() then takes its state
  /// @throws std::runtime_error if the surface does not fit into the memory of the accelerator, or has more vertices
  ///         than its kernels can count
  AcceleratedSurface(accelerator::Accelerator& accelerator, const std::vector<std::array<Index, 3>>& triangles,
                     Surface& surface);

  /// Goes on from the state of the surface.
  void load();
  /// Writes the state to the surface.
  /// @throws std::logic_error within an audio sample
  void save() const;

  /// Some vertices at the end of the next read.
  /// @param first         of them; the others follow it
  /// @param nodes         [these vertices] their places in `displacement`
  /// @param displacement  [nodes][4] x y z and a number that means nothing, m
  void displace(std::size_t first, const accelerator::Array<Index>& nodes,
                const accelerator::Array<double>& displacement);

  /// As the functions of Surface do.
  void read();
  void take(SurfaceMotion& motion);

 private:
  static constexpr int slots = static_cast<int>(Surface::reads_at_once) + 1;

  /// A low-pass, with what its outputs have so far.
  struct Filter {
    Filter(accelerator::Accelerator& accelerator, const LowPass& low_pass, std::size_t numbers);

    /// The state of the low-pass.
    void load(LowPass& low_pass);
    void save(LowPass& low_pass) const;

    std::size_t signals;
    int outputs;
    int oldest = 0;                       ///< place of the output that is completed first
    accelerator::Array<double> taps;      ///< see LowPass
    accelerator::Array<double> sums;      ///< [outputs][signals]
    accelerator::Array<double> complete;  ///< [signals] the last output that was completed
    accelerator::BackgroundRead<double> read;
  };

  void filter_reads(int completes);

  Surface& surface_;
  int triangles_, values_;  ///< their number; 3 x vertices
  accelerator::Program program_;
  accelerator::Kernel copy_displacements_, filter_displacements_, filter_pressures_;
  accelerator::Array<std::array<Index, 3>> corners_;
  accelerator::Array<double> reference_;  ///< [values] m
  accelerator::Array<double> ring_;       ///< [slots][values] displacements at the ends of reads, m
  Filter pressure_, displacement_;
  int begin_ = 0;           ///< place in the ring of the last read that was filtered
  int reads_ = 0;           ///< after it
  int reads_filtered_ = 0;  ///< of this audio sample
};

}  // namespace idiophone::surface
