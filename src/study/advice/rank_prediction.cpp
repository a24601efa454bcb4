#include "idiophone/study/advice/rank_prediction.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/resources.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"
#include "open_mpi_memory.hpp"

namespace idiophone::advice {

namespace {

/// What a rank receives in each step.
std::vector<Message> messages_of(const mesh::Part& part, motion::Halo halo) {
  std::map<int, Index> ghosts;  // of each owner
  for (const int owner : part.ghost_rank) {
    ++ghosts[owner];
  }
  std::vector<Message> messages;
  for (const auto& [owner, nodes] : ghosts) {
    messages.push_back({.sender = owner, .bytes = motion::halo_bytes({.ghost_nodes = nodes}, halo)});
  }
  return messages;
}

}  // namespace

RankPrediction predict_ranks(const bodies::Preparation& ready, const std::vector<mesh::Mesh>& meshes, int ranks,
                             const StepSeconds& one, const Network& network, const MemoryEstimate& memory) {
  const motion::Halo halo = motion::halo_of(ready.scene);
  const std::vector<std::vector<Index>> coupled = motion::coupled_nodes(ready.attachments);
  mesh::PartSize whole;
  double elsewhere = 0.0;  // what this process holds of bodies, and rank 0 will not, bytes
  mesh::for_each_part(meshes, 1, [&](const mesh::Part& part) {
    whole = mesh::size_of(part);
    elsewhere = memory.of_bodies(part);
  });
  RankPrediction result;
  result.network = network;
  result.halo = halo;
  result.steps.steps_per_full_wait = ready.steps_per_read;
  mesh::for_each_part(
      meshes, ranks,
      [&](const mesh::Part& part) {
        const mesh::PartSize size = mesh::size_of(part);
        result.largest = mesh::largest(result.largest, size);
        result.memory = std::max(result.memory, memory.of(part));
        elsewhere -= result.steps.ranks.empty() ? memory.of_bodies(part) : 0.0;
        result.steps.ranks.push_back(
            {.computing = one.force * size.work / whole.work +
                          (one.whole - one.force) * size.nodes / static_cast<double>(whole.nodes),
             .inner = halo == motion::Halo::states ? 0.0 : one.force * motion::work_without_ghosts(part) / whole.work,
             .received = messages_of(part, halo)});
      },
      coupled);
  result.step = step_time(result.steps, network);
  result.speed_up = one.whole / result.step.whole;
  constexpr double of_files = 16e6 - saved_by_open_mpi;  // what a run holds besides: 11 to 21 MB with Open MPI 4
  const bool needs_all = !ready.initial_state.displacement.empty();  // for a static equilibrium
  result.root_memory = std::max(result.memory, loop::peak_memory() + of_files - (needs_all ? 0.0 : elsewhere));
  return result;
}

void report(const RankPrediction& prediction) {
  const mesh::PartSize& size = prediction.largest;
  constexpr double mega = 1e6;
  spdlog::info("on {} ranks, one has at most:", prediction.steps.ranks.size());
  spdlog::info("  {} elements of its own and {} ghosts, {} nodes of its own and {} ghosts, {} neighbours",
               size.elements, size.ghost_elements, size.nodes, size.ghost_nodes, size.neighbours);
  spdlog::info("  {:.4g} kB of halo a step, {:.0f} MB of memory (rank 0, which prepares the run: {:.0f} MB)",
               motion::halo_bytes(size, prediction.halo) / 1e3, prediction.memory / mega,
               prediction.root_memory / mega);
  spdlog::info(
      "  a step of {:.3g} ms, {:.3g} ms of it waiting: {:.4g} times as fast as one rank, with messages of {:.3g} s, "
      "{:.3g} s of it at each end, and {:.3g} bytes/s",
      1e3 * prediction.step.whole, 1e3 * prediction.step.waiting, prediction.speed_up, prediction.network.latency,
      prediction.network.overhead, prediction.network.bandwidth);
  if (prediction.waves) {
    report(*prediction.waves);
  }
}

nlohmann::json facts_of(const RankPrediction& prediction) {
  nlohmann::json largest = loop::part_facts(prediction.largest, prediction.halo);
  return {{"ranks", prediction.steps.ranks.size()},
          {"latency", prediction.network.latency},
          {"overhead", prediction.network.overhead},
          {"ranks_on_host", prediction.network.ranks_on_host},
          {"bandwidth", prediction.network.bandwidth},
          {"largest_part", std::move(largest)},
          {"memory_bytes", prediction.memory},
          {"root_memory_bytes", prediction.root_memory},
          {"step_seconds", prediction.step.whole},
          {"waiting_seconds", prediction.step.waiting},
          {"speed_up", prediction.speed_up},
          {"waves", prediction.waves ? facts_of(*prediction.waves) : nlohmann::json()}};
}

}  // namespace idiophone::advice
