#pragma once
// Bodies that are coupled to their air, on the ranks of a communicator.

#include <cstdint>
#include <vector>

#include "checkpointed.hpp"
#include "coupled_air.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "stages.hpp"

namespace idiophone::propagation {

using propagation::CoupledAir;
using propagation::WaveGrid;

class System {
 public:
  /// @param meshes  of the bodies of the scene; only those of rank 0 count
  System(const scene::Scene& scene, std::vector<mesh::Mesh> meshes, MPI_Comm communicator)
      : ready_(bodies::prepare(scene, of_root(std::move(meshes), communicator), communicator)),
        source_(ready_, stages(), communicator),
        air_(ready_.scene, source_.surface(), source_.first_sample(), stages(), communicator),
        emission_(padded_emission(source_.surface().triangles.size())) {
    source_.couple(air_);
  }

  void start() {
    source_.start(motion_);
    air_.start(source_.first_sample(), motion_);
  }

  void advance(std::int64_t samples) {
    for (std::int64_t i = 0; i < samples; ++i) {
      source_.advance(motion_);
      air_.propagate(source_.first_sample() + ++advanced_, emission_, motion_);
    }
  }

  void archive(parallel::Archive& archive) {
    archive.root("advanced", advanced_);
    source_.archive(archive);
    air_.archive(archive);
  }

  /// Audio samples of sound, on rank 0.
  std::vector<std::vector<double>> take(std::int64_t samples) {
    advance(samples - air_.final_before(0) - source_.first_sample() - advanced_);
    return air_.take(samples);
  }

  bodies::FiniteElementSource& source() { return source_; }
  [[nodiscard]] const WaveGrid& grid() const { return air_.grid(); }
  [[nodiscard]] const bodies::Preparation& ready() const { return ready_; }
  [[nodiscard]] const scene::Scene& scene() const { return ready_.scene; }

 private:
  static std::vector<mesh::Mesh> of_root(std::vector<mesh::Mesh> meshes, MPI_Comm communicator) {
    return parallel::is_root(communicator) ? std::move(meshes) : std::vector<mesh::Mesh>{};
  }
  static surface::Emission padded_emission(std::size_t triangles) {
    surface::Emission emission;
    emission.resize(padded(triangles));
    return emission;
  }

  bodies::Preparation ready_;
  bodies::FiniteElementSource source_;
  CoupledAir air_;
  surface::SurfaceMotion motion_;
  surface::Emission emission_;
  std::int64_t advanced_ = 0;
};

}  // namespace idiophone::propagation
