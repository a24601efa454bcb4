#include "idiophone/study/advice/rank_prediction.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/resources.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::advice {

namespace {

/// How long a rank waits for its ghosts in a step, the mean of all steps, s.
/// @param inner  time of the elements that need no ghost, s
double waiting_time(double exchange, double inner, int steps_per_read, const Network& network) {
  const double hidden = network.is_shared_memory ? 0.0 : std::min(exchange, inner);
  return exchange - hidden * (steps_per_read - 1) / steps_per_read;
}

}  // namespace

RankPrediction predict_ranks(const std::vector<mesh::Mesh>& meshes, int ranks, const StepSeconds& one,
                             int steps_per_read, const Network& network, const MemoryEstimate& memory) {
  mesh::PartSize whole;
  mesh::for_each_part(meshes, 1, [&](const mesh::Part& part) { whole = mesh::size_of(part); });
  RankPrediction result;
  result.ranks = ranks;
  result.network = network;
  mesh::for_each_part(meshes, ranks, [&](const mesh::Part& part) {
    const mesh::PartSize size = mesh::size_of(part);
    result.largest = mesh::largest(result.largest, size);
    result.memory = std::max(result.memory, memory.of(part));
    const double computing =
        one.force * size.work / whole.work + (one.whole - one.force) * size.nodes / static_cast<double>(whole.nodes);
    const double exchange = size.neighbours * network.latency + motion::halo_bytes(size) / network.bandwidth;
    const double inner = one.force * motion::work_without_ghosts(part) / whole.work;
    const double waiting = waiting_time(exchange, inner, steps_per_read, network);
    if (computing + waiting > result.step_seconds) {
      result.step_seconds = computing + waiting;
      result.waiting_seconds = waiting;
    }
  });
  result.speed_up = one.whole / result.step_seconds;
  constexpr double of_files = 10e6;  // what a run holds besides, measured
  result.root_memory = std::max(result.memory, loop::peak_memory() + of_files);
  return result;
}

void report(const RankPrediction& prediction) {
  const mesh::PartSize& size = prediction.largest;
  constexpr double mega = 1e6;
  spdlog::info("on {} ranks, one has at most:", prediction.ranks);
  spdlog::info("  {} elements of its own and {} ghosts, {} nodes of its own and {} ghosts, {} neighbours",
               size.elements, size.ghost_elements, size.nodes, size.ghost_nodes, size.neighbours);
  spdlog::info("  {:.4g} kB of halo a step, {:.0f} MB of memory (rank 0, which prepares the run: {:.0f} MB)",
               motion::halo_bytes(size) / 1e3, prediction.memory / mega, prediction.root_memory / mega);
  spdlog::info(
      "  a step of {:.3g} ms, {:.3g} ms of it waiting: {:.4g} times as fast as one rank, with messages of {:.3g} s and "
      "{:.3g} bytes/s",
      1e3 * prediction.step_seconds, 1e3 * prediction.waiting_seconds, prediction.speed_up, prediction.network.latency,
      prediction.network.bandwidth);
  if (prediction.waves) {
    report(*prediction.waves);
  }
}

nlohmann::json facts_of(const RankPrediction& prediction) {
  nlohmann::json largest = loop::part_facts(prediction.largest);
  return {{"ranks", prediction.ranks},
          {"latency", prediction.network.latency},
          {"bandwidth", prediction.network.bandwidth},
          {"largest_part", std::move(largest)},
          {"memory_bytes", prediction.memory},
          {"root_memory_bytes", prediction.root_memory},
          {"step_seconds", prediction.step_seconds},
          {"waiting_seconds", prediction.waiting_seconds},
          {"speed_up", prediction.speed_up},
          {"waves", prediction.waves ? facts_of(*prediction.waves) : nlohmann::json()}};
}

}  // namespace idiophone::advice
