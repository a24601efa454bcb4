#include "idiophone/study/advice/rank_prediction.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/resources.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::advice {

RankPrediction predict_ranks(const std::vector<mesh::Mesh>& meshes, int ranks, const StepSeconds& one,
                             const Network& network, const MemoryEstimate& memory) {
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
    result.step_seconds = std::max(result.step_seconds, computing + exchange);
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
      "  a step of {:.3g} ms: {:.4g} times as fast as one rank, with {:.3g} s for a message and {:.3g} bytes/s",
      1e3 * prediction.step_seconds, prediction.speed_up, prediction.network.latency, prediction.network.bandwidth);
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
          {"speed_up", prediction.speed_up}};
}

}  // namespace idiophone::advice
