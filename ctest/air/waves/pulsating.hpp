#pragma once
// Spheres that pulsate in one pulse, in grids that may be divided.

#include <array>
#include <optional>
#include <ostream>
#include <vector>

#include "idiophone/air/waves/surface_sources.hpp"
#include "idiophone/air/waves/velocity_history.hpp"
#include "idiophone/air/waves/wave_field.hpp"
#include "vibrating_solid.hpp"

namespace idiophone::waves {

inline constexpr double test_courant = 0.55;

/// Cells of 1 cm about the origin.
[[nodiscard]] Grid grid_of(std::array<int, 3> cells, int layer);

/// A sphere in a grid.
struct Setting {
  const char* name;
  Grid grid;
  double radius;  ///< m
  std::optional<LossyAir> lossy;
};
void PrintTo(const Setting& setting, std::ostream* out);

/// Of cells that no number of ranks divides evenly; one with large losses at walls; on a rigid floor; and a long one
/// that eight ranks divide along all axes, and the sphere with it.
[[nodiscard]] std::vector<Setting> settings();

/// On any division of its grid.
class Pulsating {
 public:
  /// @param accelerator  null: the processor computes
  Pulsating(const Setting& setting, int ranks, MPI_Comm communicator, accelerator::Accelerator* accelerator = nullptr);

  /// Puts the sphere so far from the origin.
  void set(const Vector3& shift);
  void advance(int steps);
  /// So many audio samples of three steps each, of which only the velocities at their beginning are known.
  void advance_samples(int samples);
  [[nodiscard]] WaveField& field() { return field_; }

 private:
  WaveField field_;
  radiation::Solid solid_;
  std::vector<float> positions_, changes_, node_sources_;
  SurfaceSources sources_;
  VelocityHistory history_;
  int step_ = 0;
};

}  // namespace idiophone::waves
