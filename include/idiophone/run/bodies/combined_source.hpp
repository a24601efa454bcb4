#pragma once
// Several sources that sound at once and shadow each other: their surfaces are one surface.

#include <memory>
#include <vector>

#include "idiophone/run/bodies/source.hpp"

namespace idiophone::bodies {

/// A source that begins later than the others is steady until then.
class CombinedSource : public Source {
 public:
  /// @param sources  at least one
  explicit CombinedSource(std::vector<std::unique_ptr<Source>> sources);

  [[nodiscard]] std::int64_t first_sample() const override { return first_sample_; }
  void couple(propagation::AirLoad& air) override;
  void start(surface::SurfaceMotion& motion) override;
  void advance(surface::SurfaceMotion& motion) override;
  [[nodiscard]] std::vector<ChannelGroup*> channels() override;
  void check() override;
  void archive(parallel::Archive& archive) override;
  /// Until the last source has begun.
  [[nodiscard]] std::int64_t samples_before_archive() const override;
  void report() const override;

 private:
  struct MovingSource {
    std::unique_ptr<Source> source;
    surface::SurfaceMotion motion;  ///< its present one
  };
  void join(surface::SurfaceMotion& motion) const;

  std::vector<MovingSource> sources_;
  std::int64_t first_sample_;
  std::int64_t sample_;  ///< audio sample of the present motion
};

}  // namespace idiophone::bodies
