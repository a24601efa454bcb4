#pragma once
// What a run on many ranks needs and gains, predicted by one process from the parts that METIS makes.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "idiophone/solids/mesh/part_size.hpp"
#include "idiophone/study/advice/memory_estimate.hpp"
#include "idiophone/study/advice/network.hpp"
#include "idiophone/study/advice/rank_steps.hpp"
#include "idiophone/study/advice/step_measurement.hpp"
#include "idiophone/study/advice/wave_prediction.hpp"

namespace idiophone::advice {

struct RankPrediction {
  Network network;
  RankSteps steps;
  mesh::PartSize largest;    ///< the largest number of any rank
  double memory = 0.0;       ///< of the rank that needs most while it runs, bytes
  double root_memory = 0.0;  ///< of rank 0, which prepares the run, at its peak, bytes
  StepTime step;
  double speed_up = 1.0;                ///< over one rank
  std::optional<WavePrediction> waves;  ///< none: another radiation model
};

/// Cuts the bodies into parts. The elements' time is divided like their work, all else like the nodes. Messages travel
/// while elements that need no ghost are computed, except before the surface is read. Contact and waves are not
/// counted.
/// @param meshes          of all bodies
/// @param one             of a run on one rank
/// @param steps_per_read  steps from one reading of the surface to the next
/// @throws std::runtime_error when there are more ranks than elements can fill
[[nodiscard]] RankPrediction predict_ranks(const std::vector<mesh::Mesh>& meshes, int ranks, const StepSeconds& one,
                                           int steps_per_read, const Network& network, const MemoryEstimate& memory);

void report(const RankPrediction& prediction);

[[nodiscard]] nlohmann::json facts_of(const RankPrediction& prediction);

}  // namespace idiophone::advice
