#pragma once
// Sound that travels from each triangle to each receiver on a straight line, by way of a floor as well, unless
// something stands in the way.

#include <mpi.h>

#include <memory>
#include <optional>

#include "idiophone/air/propagation/air.hpp"
#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/propagation/body_frames.hpp"
#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/air/propagation/line_of_sight.hpp"
#include "idiophone/foundation/parallel/stages.hpp"

namespace idiophone::propagation {

class StraightAir : public Air {
 public:
  /// Collective.
  /// @param acoustics   whose listeners hear; must outlive this object, as must `stages`
  /// @param steady  audio sample of the steady motion that comes first
  /// @throws std::runtime_error when Embree fails
  StraightAir(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, std::int64_t steady,
              parallel::Stages& stages, MPI_Comm communicator);

  [[nodiscard]] std::string unit() const override { return std::string(ears_.model().unit()); }
  [[nodiscard]] std::string description() const override { return std::string(ears_.model().description()); }
  void start(std::int64_t sample, const surface::SurfaceMotion& steady) override;
  void propagate(std::int64_t sample, const surface::Emission& emission, const surface::SurfaceMotion& motion) override;
  [[nodiscard]] std::int64_t final_before(std::int64_t sample) const override { return ears_.final_before(sample); }
  [[nodiscard]] std::vector<std::vector<double>> take(std::size_t count) override {
    return ears_.take(count, communicator_);
  }
  void archive(parallel::Archive& archive) override;

 private:
  parallel::Stages& stages_;
  MPI_Comm communicator_;
  parallel::Rows triangle_rows_;
  Ears ears_;
  std::unique_ptr<BodyFrames> frames_;        ///< none: no listener is attached to a body
  std::optional<LineOfSight> line_of_sight_;  ///< none: everything is seen from everywhere
};

}  // namespace idiophone::propagation
