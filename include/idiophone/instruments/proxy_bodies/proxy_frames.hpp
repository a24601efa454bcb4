#pragma once
// Proxies that move and vibrate, as frames of a result.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/rows.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_source.hpp"
#include "idiophone/run/record/recorder.hpp"
#include "idiophone/run/results/result_file.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::proxy_bodies {

/// Adds the mesh of a body to a result, on one rank.
/// @param nodes  m
/// @return the rows of its nodes, for its frames
parallel::Rows add_tetrahedra(const std::string& body, std::span<const Vector3> nodes,
                              std::span<const std::array<Index, 4>> tetrahedra, results::ResultFile& result);

/// Frames as `run` writes them, of all masses. For one rank only.
class ProxyFrames : public record::Recorder {
 public:
  /// @param bodies  those of the source
  /// @param source, scene, result  must outlive this object
  ProxyFrames(std::vector<ProxyBody> bodies, const ProxySource& source, const scene::Scene& scene,
              results::ResultFile& result);

  void declare() override;
  void note(std::int64_t sample, const surface::SurfaceMotion& motion) override;
  void write() override;
  /// The result archives its lengths.
  void archive(parallel::Archive& /*archive*/) override {}

 private:
  struct Frame {
    double time = 0.0;                              ///< s
    std::vector<std::vector<double>> displacement;  ///< [bodies][3 x masses], m
  };

  std::vector<ProxyBody> bodies_;
  const ProxySource& source_;
  const scene::Scene& scene_;
  results::ResultFile& result_;
  std::vector<parallel::Rows> nodes_;  ///< [bodies]
  std::vector<Frame> frames_;          ///< not yet written
};

}  // namespace idiophone::proxy_bodies
