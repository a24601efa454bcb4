#include "idiophone/study/advice/wave_prediction.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "idiophone/air/waves/division.hpp"

namespace idiophone::advice {

namespace {

/// What a rank computes and exchanges in a step.
/// @param of_cell  time of a cell, s
RankStep step_of(const waves::Division& division, int rank, double of_cell) {
  const auto cells = static_cast<double>(division.cells(rank).size());
  double at_faces = 0.0;  // cells that are computed before the messages are sent
  RankStep step;
  for (const waves::Face& face : division.faces(rank)) {
    const auto ghosts = static_cast<double>(face.ghost_cells.size());
    step.received.push_back({.sender = face.neighbour, .bytes = ghosts * sizeof(float)});
    at_faces += ghosts * (face.axis == 0 ? waves::Grid::row_multiple : 1);
  }
  step.computing = of_cell * cells;
  step.inner = of_cell * std::max(0.0, cells - at_faces);
  return step;
}

double bytes_of(const std::vector<Message>& messages) {
  double bytes = 0.0;
  std::ranges::for_each(messages, [&](const Message& message) { bytes += message.bytes; });
  return bytes;
}

}  // namespace

WavePrediction predict_waves(const waves::Plan& plan, int ranks, std::optional<double> one, const Network& network) {
  const waves::Division division(plan.grid, ranks);
  const double of_cell = one.value_or(0.0) / plan.cells();
  RankSteps steps;
  WavePrediction result;
  for (int rank = 0; rank < ranks; ++rank) {
    const RankStep& step = steps.ranks.emplace_back(step_of(division, rank, of_cell));
    result.cells = std::max(result.cells, static_cast<double>(division.cells(rank).size()));
    result.neighbours = std::max(result.neighbours, static_cast<int>(step.received.size()));
    result.halo_bytes = std::max(result.halo_bytes, bytes_of(step.received));
  }
  result.memory = plan.bytes() * result.cells / plan.cells();
  if (one) {
    const StepTime step = step_time(steps, network);
    result.times = {.steps = std::move(steps), .step = step, .speed_up = *one / step.whole};
  }
  return result;
}

void report(const WavePrediction& prediction) {
  spdlog::info("  waves: at most {:.0f} cells, {} neighbours and {:.4g} kB of ghost cells a step, {:.0f} MB of memory",
               prediction.cells, prediction.neighbours, prediction.halo_bytes / 1e3, prediction.memory / 1e6);
  if (const auto& times = prediction.times) {
    spdlog::info("  a step of waves of {:.3g} ms, {:.3g} ms of it waiting: {:.4g} times as fast as one rank",
                 1e3 * times->step.whole, 1e3 * times->step.waiting, times->speed_up);
  }
}

nlohmann::json facts_of(const WavePrediction& prediction) {
  nlohmann::json facts = {{"cells", prediction.cells},
                          {"neighbours", prediction.neighbours},
                          {"halo_bytes", prediction.halo_bytes},
                          {"memory_bytes", prediction.memory},
                          {"step_seconds", nullptr},
                          {"waiting_seconds", nullptr},
                          {"speed_up", nullptr}};
  if (const auto& times = prediction.times) {
    facts["step_seconds"] = times->step.whole;
    facts["waiting_seconds"] = times->step.waiting;
    facts["speed_up"] = times->speed_up;
  }
  return facts;
}

}  // namespace idiophone::advice
