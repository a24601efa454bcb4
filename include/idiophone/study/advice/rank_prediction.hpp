#pragma once
// What a run on many ranks needs and gains, predicted by fewer processes from the parts that the ranks would have.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/mesh/part_size.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"
#include "idiophone/study/advice/memory_estimate.hpp"
#include "idiophone/study/advice/network.hpp"
#include "idiophone/study/advice/rank_steps.hpp"
#include "idiophone/study/advice/step_measurement.hpp"
#include "idiophone/study/advice/wave_prediction.hpp"

namespace idiophone::advice {

struct RankPrediction {
  Network network;
  RankSteps steps;
  motion::Halo halo = motion::Halo::velocities;
  mesh::PartSize largest;    ///< the largest number of any rank
  double memory = 0.0;       ///< of the rank that needs most while it runs, bytes
  double root_memory = 0.0;  ///< of rank 0, which prepares the run, at its peak, bytes
  StepTime step;
  double speed_up = 1.0;                ///< over one rank
  std::optional<WavePrediction> waves;  ///< none: another radiation model
};

/// What predict_ranks() needs, before meshes are read. Collective.
/// @throws std::runtime_error, on every process, where there are fewer ranks than processes, or several processes would
///         read the meshes whole
void require_fitting_processes(const scene::Scene& scene, int ranks, MPI_Comm communicator);

/// Cuts the bodies into parts as a run would: by METIS on one process, or along the curve where each process has read
/// its part of the meshes. The elements' time is divided like their work, all else like the nodes. Messages travel
/// while elements that need no ghost are computed, except before the surface is read; states do so alone. Contact and
/// waves are not counted. Collective.
/// @param prepared  with rows where the meshes were read in parts; they are used up
/// @param measured  of this process's part
/// @param ranks     that require_fitting_processes() accepts
/// @throws std::runtime_error when there are more ranks than elements can fill
[[nodiscard]] RankPrediction predict_ranks(bodies::PreparedMeshes& prepared, int ranks, const StepMeasurement& measured,
                                           const Network& network, MPI_Comm communicator);

void report(const RankPrediction& prediction);

[[nodiscard]] nlohmann::json facts_of(const RankPrediction& prediction);

}  // namespace idiophone::advice
