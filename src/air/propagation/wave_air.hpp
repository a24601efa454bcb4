#pragma once
// Sound that travels as waves on a grid around the bodies, and from a box in this grid on to the listeners.

#include <mpi.h>

#include <optional>

#include "idiophone/air/propagation/air.hpp"
#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/air/waves/velocity_history.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/stages.hpp"
#include "local_pressures.hpp"
#include "wave_grid.hpp"

namespace idiophone::propagation {

/// Every rank gets the motion of all surfaces, one audio sample late, and computes the waves in its subdomain of the
/// grid.
class WaveAir : public Air {
 public:
  /// Collective.
  /// @param acoustics   whose listeners hear; must outlive this object, as must `stages`
  /// @param steady  audio sample of the steady motion that comes first
  /// @param accelerator  as for WaveGrid; null: the processor computes
  /// @throws std::runtime_error as WaveGrid
  WaveAir(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, std::int64_t steady,
          parallel::Stages& stages, MPI_Comm communicator, accelerator::Accelerator* accelerator = nullptr);

  [[nodiscard]] std::string unit() const override { return std::string(ears_.model().unit()); }
  [[nodiscard]] std::string description() const override { return std::string(ears_.model().description()); }
  void start(std::int64_t sample, const surface::SurfaceMotion& steady) override;
  /// Waits for the neighbouring ranks, and until all ranks have begun the audio sample before. The ears hear the grid
  /// when the next audio sample has begun, so that the processor does not wait for an accelerator.
  void propagate(std::int64_t sample, const surface::Emission& emission, const surface::SurfaceMotion& motion) override;
  void finish() override;
  [[nodiscard]] std::int64_t final_before(std::int64_t sample) const override {
    return ears_.final_before(sample - latency());
  }
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count) override;
  void archive(parallel::Archive& archive) override;

 private:
  /// The waves are at an audio sample so many before the newest emission.
  [[nodiscard]] static std::int64_t latency() { return waves::VelocityHistory::latency() + 1; }
  void receive();
  /// Pressures of the grid at an audio sample, at the box; LocalPressures::sounds() are of the same moment.
  struct Arrived {
    std::int64_t sample;
    const surface::Emission& emission;
  };
  /// Begins to read the pressures of the present, which are those of this audio sample.
  void begin_reads(std::int64_t sample);
  [[nodiscard]] std::optional<Arrived> wait_for_pressures();
  void hear(const Arrived& arrived);
  /// The audio sample that is on the way, if there is one.
  void hear_the_rest();
  void require_finished() const;
  [[nodiscard]] std::vector<float> own_pressures(const std::vector<double>& padded) const;
  [[nodiscard]] std::vector<float> in_global_order(std::span<const float> gathered) const;

  scene::Acoustics acoustics_;
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  WaveGrid grid_;
  parallel::Gathered<Index> triangle_ids_;
  parallel::BackgroundGather<float> shared_pressures_;
  bool sending_ = false;
  waves::VelocityHistory history_;
  Ears ears_;
  LocalPressures local_pressures_;          // at the ears
  std::optional<std::int64_t> on_the_way_;  // audio sample of which the grid's pressures are being read
};

}  // namespace idiophone::propagation
