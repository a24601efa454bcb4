#pragma once
// Mass-spring proxies whose surfaces are heard through any radiation model.

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "idiophone/air/surface/surface.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/run/bodies/source.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::proxy_bodies {

/// A body of a ProxySource.
struct ProxyBody {
  std::string name;
  std::shared_ptr<const proxies::Lattice> lattice;
  /// From the coordinates of the undeformed body to where it is at a time, s. Empty: it stays where it is.
  std::function<Eigen::Isometry3d(double time)> track{};
};

/// Proxies at rest, moved by forces. Their springs are computed several times in each audio sample, so that the
/// low-pass of the surface has what it needs. Tracks move the surfaces, but make no sound themselves. For one rank
/// only.
class ProxySource : public bodies::Source {
 public:
  /// @param bodies   at least one
  /// @param forces   on these bodies, in any order
  /// @param scene    its audio and radiation
  /// @param options  of all proxies; the rate is chosen here
  /// @throws std::invalid_argument as proxies::Proxy does; std::runtime_error where the air shall act on the bodies
  ProxySource(const std::vector<ProxyBody>& bodies, std::vector<proxies::Force> forces, const scene::Scene& scene,
              const proxies::ProxyOptions& options);

  [[nodiscard]] std::int64_t first_sample() const override { return -surface_.sampling().latency(); }
  void start(surface::SurfaceMotion& motion) override;
  void advance(surface::SurfaceMotion& motion) override;
  /// Where the masses of a body are now, from where they are in its lattice, with its track: [3 x masses], m.
  [[nodiscard]] std::vector<double> displacement(std::size_t body) const;

  /// Audio samples that it has advanced.
  [[nodiscard]] std::int64_t advanced() const { return sample_; }

  /// @throws std::logic_error always: proxies are rendered without checkpoints
  void archive(parallel::Archive& archive) override;

 private:
  struct ActingForce {
    proxies::Force force;
    proxies::Contact contact;
  };
  /// Forces on a body in the present audio sample.
  void find_forces(std::size_t body);
  void write_displacements();
  void follow_tracks(surface::SurfaceMotion& motion) const;

  std::vector<proxies::Proxy> proxies_;                                // [bodies]
  std::vector<std::function<Eigen::Isometry3d(double time)>> tracks_;  // [bodies]
  std::vector<ActingForce> forces_;                                    // by their start
  std::vector<Index> masses_;                                          // [vertices] mass of its body
  surface::Surface surface_;
  std::vector<proxies::PointForce> present_;
  std::int64_t sample_ = 0;  // audio samples advanced
};

}  // namespace idiophone::proxy_bodies
