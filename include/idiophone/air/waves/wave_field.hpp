#pragma once
// Sound waves in the air around bodies, in the time domain.

#include <mpi.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/division.hpp"
#include "idiophone/air/waves/lossy_air.hpp"
#include "idiophone/air/waves/pressure_probe.hpp"
#include "idiophone/foundation/accelerator/accelerator.hpp"
#include "idiophone/foundation/parallel/archive.hpp"

namespace idiophone::waves {

class FaceExchange;
class FieldSteps;
class SurfaceSources;
class VelocityHistory;
struct FieldState;

/// The pressure of cells and nodes, and its change in a step. Pressure and velocity on a staggered grid, advanced by
/// leapfrog, with the velocities eliminated: a rate is minus rho c^2 dt/V times what flows out of a cell. With the
/// Courant number C = c dt/h, and areas A and volumes V over those of a cell, a step is
///   rate += C^2/V sum A (p_neighbour - p) + source,   p += rate.
/// Every cell has the same value on any number of ranks, to the bit.
class WaveField {
 public:
  /// The largest stable Courant number is 1/sqrt(3); a little is left for rounding.
  static constexpr double largest_courant = 0.57;

  /// Air at rest without surfaces. Collective, as is the end.
  /// @param communicator  of as many ranks as the division has
  /// @param lossy         what decides the losses at walls; none: walls take nothing
  /// @param accelerator   which computes the steps and must outlive this object; null: the processor does
  /// @throws std::runtime_error, on all ranks, if the field does not fit into the memory of an accelerator
  WaveField(const Division& division, double courant, MPI_Comm communicator, const std::optional<LossyAir>& lossy = {},
            accelerator::Accelerator* accelerator = nullptr);
  ~WaveField();
  WaveField(const WaveField&) = delete;
  WaveField& operator=(const WaveField&) = delete;
  WaveField(WaveField&&) = delete;
  WaveField& operator=(WaveField&&) = delete;

  /// Of this rank.
  [[nodiscard]] const Subdomain& subdomain() const;
  [[nodiscard]] const CutCells& cut_cells() const;

  /// Whether walls take sound.
  [[nodiscard]] bool is_lossy() const { return lossy_.has_value(); }

  /// Puts surfaces in place of those before. Air keeps its pressure; where air appears, it takes that of its
  /// neighbours. Exchanges with the neighbouring ranks.
  /// @param cut_cells  with walls if there are losses at them
  void set_surfaces(CutCells cut_cells);

  /// One step. Exchanges with the neighbouring ranks.
  /// @param sources  [cut_cells().nodes()] what surfaces add to the rates of the nodes, Pa per step
  void step(std::span<const float> sources);
  /// The same with surfaces whose velocities are known at the audio rate.
  /// @param sources     of the surfaces that are in place
  /// @param velocities  rho c v_n of their triangles, Pa. An accelerator keeps a copy of them, so they must be the same
  ///                    object in each step
  /// @param step        of the audio sample, from 0 on
  void step(const SurfaceSources& sources, const VelocityHistory& velocities, int step);

  /// The pressures in the middle of the next step if no surface changes its velocity before the end of it.
  /// @param pressures  [cut_cells().nodes()] Pa; those of ghost cells are left as they are
  void forecast(std::span<float> pressures);

  /// Of a cell of the subdomain or of a ghost cell at one of its faces, by its number in the subdomain, Pa. Of a cell
  /// with several nodes, that of the first one. Several cells are read sooner by a probe.
  [[nodiscard]] float pressure(Index cell) const;
  /// For tests and initial fields, Pa.
  void set_pressure(Index cell, float pressure);
  /// Of several cells, as pressure().
  /// @return which the field must outlive
  [[nodiscard]] std::unique_ptr<PressureProbe> probe(std::vector<Index> cells) const;

  /// The nodes must be those of the archived surfaces. Restores what decides the future. Collective.
  void archive(parallel::Archive& archive);

 private:
  void renew_losses(const CutCells& before);
  void exchange();
  void archive_cells(parallel::Archive& archive);
  void archive_layers(parallel::Archive& archive);
  void archive_nodes(parallel::Archive& archive);

  std::optional<LossyAir> lossy_;
  std::unique_ptr<FieldState> state_;
  std::unique_ptr<FaceExchange> exchange_;
  std::unique_ptr<FieldSteps> steps_;
};

}  // namespace idiophone::waves
