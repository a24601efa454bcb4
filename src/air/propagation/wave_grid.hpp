#pragma once
// The waves around surfaces that move: the grid, and where the surfaces are in it.

#include <mpi.h>

#include <array>
#include <span>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/propagation/shared_positions.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/air/waves/enclosing_box.hpp"
#include "idiophone/air/waves/plan.hpp"
#include "idiophone/air/waves/surface_coupling.hpp"
#include "idiophone/air/waves/surface_sources.hpp"
#include "idiophone/air/waves/velocity_history.hpp"
#include "idiophone/air/waves/wave_field.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::propagation {

/// A rank computes the waves in its subdomain of the grid. Every rank gets the positions of all surfaces, one audio
/// sample late.
class WaveGrid {
 public:
  /// Collective.
  /// @param accelerator  as for waves::WaveField
  /// @throws std::runtime_error as wave_plan(), waves::Division and waves::WaveField
  WaveGrid(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, MPI_Comm communicator,
           accelerator::Accelerator* accelerator);

  [[nodiscard]] const waves::Plan& plan() const { return plan_; }
  [[nodiscard]] const waves::Division& division() const { return division_; }
  [[nodiscard]] const waves::WaveField& field() const { return field_; }
  /// Triangles of the bodies, on all ranks.
  [[nodiscard]] std::size_t moving() const { return moving_; }
  /// Of the bodies and of the obstacles, where the grid has them; on every rank the same.
  [[nodiscard]] waves::Obstruction obstruction() const { return {triangles_, positions_}; }

  /// Puts the surfaces where they are. Collective.
  /// @throws std::runtime_error when they are not within the grid
  void start(const surface::SurfaceMotion& steady);

  /// Begins to send where the surfaces are, if it is time: the grid takes notice of motion 1000 times a second.
  void send_positions(std::int64_t sample, const surface::SurfaceMotion& motion);

  /// Waits until all ranks have sent, and moves the surfaces.
  /// @return whether they moved
  /// @throws std::runtime_error, on all ranks, when a body leaves the grid; it has failed() then, and takes no step
  bool receive_positions();
  [[nodiscard]] bool failed() const { return failed_; }

  /// One step. Exchanges with the neighbouring ranks.
  /// @param velocities  [moving()] as for waves::WaveField
  /// @param step        of the audio sample
  void step(const waves::VelocityHistory& velocities, int step) { field_.step(sources_, velocities, step); }
  /// Of surfaces that feel the air.
  /// @param changes  [moving() x 3 corners] of rho c v_n, Pa
  void step(std::span<const float> changes);

  /// Of the grid's present pressures, half a step ahead: see waves::SurfaceCoupling::forces.
  [[nodiscard]] const std::vector<waves::ForceShare>& forces();

  /// This rank's patches of the box around the bodies.
  [[nodiscard]] std::size_t patches() const { return box_.patches(); }
  /// The rows of an archive that they are.
  [[nodiscard]] const parallel::Rows& patch_rows() const { return patch_rows_; }
  /// The air at the box, as waves::EnclosingBox does it.
  void begin_emission() { box_.begin(); }
  [[nodiscard]] const surface::Emission& finish_emission() { return box_.finish(); }

  /// Receives what is on its way. Restoring takes the place of start(). Collective.
  void archive(parallel::Archive& archive);

 private:
  [[nodiscard]] bool have_moved(std::span<const float> positions) const;
  void require_within_reach(std::span<const float> positions);
  void set_surfaces();

  int update_interval_;  // audio samples
  waves::Plan plan_;
  std::vector<std::array<Index, 3>> triangles_;  // of the bodies, then of the obstacles
  std::size_t moving_;
  bool feels_air_;                // the bodies
  std::vector<float> positions_;  // of their vertices, as the grid has them, m
  std::vector<float> arrived_;    // of the bodies' vertices, m
  SharedPositions shared_positions_;
  bool sending_ = false;
  bool failed_ = false;  // on all ranks alike
  waves::Division division_;
  waves::WaveField field_;
  waves::SurfaceSources sources_;    // if they do not feel the air
  waves::SurfaceCoupling coupling_;  // if they do
  std::vector<float> of_nodes_;      // what the surfaces add to them, or their pressures
  waves::EnclosingBox box_;
  parallel::Rows patch_rows_;
};

}  // namespace idiophone::propagation
