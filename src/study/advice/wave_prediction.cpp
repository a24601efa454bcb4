#include "idiophone/study/advice/wave_prediction.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "idiophone/air/waves/division.hpp"

namespace idiophone::advice {

namespace {

/// What a rank computes and exchanges in a step.
struct Share {
  double cells = 0.0;
  double at_faces = 0.0;  ///< of these, computed before the messages are sent
  double received = 0.0;  ///< ghost cells
  int neighbours = 0;
};

Share share_of(const waves::Division& division, int rank) {
  Share share;
  share.cells = static_cast<double>(division.cells(rank).size());
  for (const waves::Face& face : division.faces(rank)) {
    const auto cells = static_cast<double>(face.ghost_cells.size());
    share.received += cells;
    share.at_faces += cells * (face.axis == 0 ? waves::Grid::row_multiple : 1);
    ++share.neighbours;
  }
  share.at_faces = std::min(share.at_faces, share.cells);
  return share;
}

}  // namespace

WavePrediction predict_waves(const waves::Plan& plan, int ranks, double one, const Network& network) {
  const waves::Division division(plan.grid, ranks);
  const double of_cell = one / plan.cells();  // s
  WavePrediction result;
  for (int rank = 0; rank < ranks; ++rank) {
    const Share share = share_of(division, rank);
    const double bytes = share.received * sizeof(float);
    const double exchange = share.neighbours * network.latency + bytes / network.bandwidth;
    const double hidden = network.is_shared_memory ? 0.0 : of_cell * (share.cells - share.at_faces);
    const double waiting = std::max(0.0, exchange - hidden);
    result.cells = std::max(result.cells, share.cells);
    result.neighbours = std::max(result.neighbours, share.neighbours);
    result.halo_bytes = std::max(result.halo_bytes, bytes);
    if (const double whole = of_cell * share.cells + waiting; whole > result.step_seconds) {
      result.step_seconds = whole;
      result.waiting_seconds = waiting;
    }
  }
  result.memory = plan.bytes() * result.cells / plan.cells();
  result.speed_up = one / result.step_seconds;
  return result;
}

void report(const WavePrediction& prediction) {
  spdlog::info("  waves: at most {:.0f} cells, {} neighbours and {:.4g} kB of ghost cells a step, {:.0f} MB of memory",
               prediction.cells, prediction.neighbours, prediction.halo_bytes / 1e3, prediction.memory / 1e6);
  spdlog::info("  a step of waves of {:.3g} ms, {:.3g} ms of it waiting: {:.4g} times as fast as one rank",
               1e3 * prediction.step_seconds, 1e3 * prediction.waiting_seconds, prediction.speed_up);
}

nlohmann::json facts_of(const WavePrediction& prediction) {
  return {{"cells", prediction.cells},
          {"neighbours", prediction.neighbours},
          {"halo_bytes", prediction.halo_bytes},
          {"memory_bytes", prediction.memory},
          {"step_seconds", prediction.step_seconds},
          {"waiting_seconds", prediction.waiting_seconds},
          {"speed_up", prediction.speed_up}};
}

}  // namespace idiophone::advice
