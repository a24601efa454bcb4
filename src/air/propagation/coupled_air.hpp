#pragma once
// Waves on a grid around bodies that feel their pressure.

#include <mpi.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/air/propagation/air.hpp"
#include "idiophone/air/propagation/air_load.hpp"
#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/air/surface/low_pass.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "surface_exchange.hpp"
#include "wave_grid.hpp"

namespace idiophone::propagation {

/// The grid is advanced with the bodies, as their AirLoad. What it does at the box around the bodies is low-passed to
/// the audio rate and goes on from there to the listeners.
class CoupledAir : public Air, public propagation::AirLoad {
 public:
  /// Collective.
  /// @param acoustics   whose listeners hear; must outlive this object, as must `stages`
  /// @param steady  audio sample of the steady motion that comes first, which is at time 0
  /// @param accelerator  as for WaveGrid; null: the processor computes
  /// @throws std::runtime_error as WaveGrid
  CoupledAir(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, std::int64_t steady,
             parallel::Stages& stages, MPI_Comm communicator, accelerator::Accelerator* accelerator = nullptr);

  [[nodiscard]] std::string unit() const override { return std::string(ears_.model().unit()); }
  [[nodiscard]] std::string description() const override { return std::string(ears_.model().description()); }
  [[nodiscard]] propagation::AirLoad* load() override { return this; }
  void start(std::int64_t sample, const surface::SurfaceMotion& steady) override;
  /// The velocities of the surfaces are known already; of their motion, the positions are used.
  void propagate(std::int64_t sample, const surface::Emission& emission, const surface::SurfaceMotion& motion) override;
  [[nodiscard]] std::int64_t final_before(std::int64_t sample) const override {
    return ears_.final_before(sample - latency_);
  }
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count) override {
    return ears_.take(count, communicator_);
  }
  void archive(parallel::Archive& archive) override;

  [[nodiscard]] int steps() const override { return grid_.plan().steps; }
  void connect(const std::vector<Index>& triangles) override;
  void advance(std::span<const double> changes, std::span<double> force, std::span<double> resistance) override;

  [[nodiscard]] const WaveGrid& grid() const { return grid_; }

 private:
  [[nodiscard]] surface::Emission emission_at_rest();
  void move_surfaces();
  void find_near();
  void step(std::span<const double> changes);
  void filter(int step);
  void require_outside(std::span<const Vector3> ears) const;

  double impedance_;  // of the air, Pa s/m
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  WaveGrid grid_;
  std::optional<SurfaceExchange> exchange_;
  std::vector<double> velocity_changes_;  // [triangles of all ranks x 3 corners] m/s
  std::vector<float> pressure_changes_;   // rho c times these, Pa
  int step_ = 0;                          // of the audio sample
  std::string problem_;
  surface::Emission heard_;               // at the box, low-passed
  surface::LowPass pressure_, gradient_;  // at the box
  std::int64_t latency_;                  // what is heard belongs to an audio sample so many before the one propagated
  Ears ears_;
};

}  // namespace idiophone::propagation
