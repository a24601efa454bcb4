#include "idiophone/study/advice/rank_prediction.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/run/bodies/reading_in_parts.hpp"
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

/// The parts of ranks that this process cuts out, as a run has them.
void for_each_part(bodies::PreparedMeshes& prepared, int ranks, const std::function<void(const mesh::Part&)>& visit,
                   MPI_Comm communicator) {
  const bodies::Preparation& ready = prepared.ready;
  const std::vector<std::vector<Index>> coupled = motion::coupled_nodes(ready.attachments);
  if (!prepared.rows.empty()) {
    mesh::for_each_part_in_rows(ready.scene.bodies, prepared.meshes, ready.offsets, prepared.rows, coupled, ranks,
                                visit, communicator);
  } else {
    mesh::for_each_part(prepared.meshes, ranks, visit, coupled);
  }
}

/// Each element once.
double work_of_all(const bodies::Preparation& ready) {
  double work = 0.0;
  for (std::size_t body = 0; body < ready.scene.bodies.size(); ++body) {
    const Index elements = ready.offsets.elements[body + 1] - ready.offsets.elements[body];
    work += elements * mesh::work_of_element(ready.scene.bodies[body].element);
  }
  return work;
}

/// What elements and nodes take, s.
struct Rates {
  double unit_of_work;
  double node;
};

/// Collective.
Rates rates_of(const bodies::Preparation& ready, const StepSeconds& measured, MPI_Comm communicator) {
  const double computed = parallel::sum(mesh::size_of(ready.part).work, communicator);  // with ghosts
  return {measured.force / computed, (measured.whole - measured.force) / ready.offsets.nodes.back()};
}

/// All processes' ranks. Collective.
std::vector<RankStep> gathered(const std::vector<RankStep>& own, MPI_Comm communicator) {
  struct Times {
    double computing, inner;
    std::size_t messages;
  };
  std::vector<Times> times;
  std::vector<Message> messages;
  for (const RankStep& step : own) {
    times.push_back({step.computing, step.inner, step.received.size()});
    messages.insert(messages.end(), step.received.begin(), step.received.end());
  }
  const std::vector<Message> all = parallel::gather_all<Message>(messages, communicator).values;
  std::vector<RankStep> steps;
  auto next = all.begin();
  for (const auto& [computing, inner, count] : parallel::gather_all<Times>(times, communicator).values) {
    const auto end = next + static_cast<std::ptrdiff_t>(count);
    steps.push_back({computing, inner, {next, end}});
    next = end;
  }
  return steps;
}

/// The largest of all processes. Collective.
mesh::PartSize largest(const mesh::PartSize& own, MPI_Comm communicator) {
  mesh::PartSize all;
  for (const mesh::PartSize& one : parallel::gather(own, communicator)) {
    all = mesh::largest(all, one);
  }
  return all;
}

}  // namespace

void require_fitting_processes(const scene::Scene& scene, int ranks, MPI_Comm communicator) {
  const int processes = parallel::size_of(communicator);
  if (processes > 1 && !bodies::reads_in_parts(scene, communicator)) {
    throw std::runtime_error(
        "check --ranks needs one process where meshes are read whole: start it without mpirun. Meshes are read in "
        "parts from 4 million elements of .h5 files on");
  }
  if (ranks < processes) {
    throw std::runtime_error(
        fmt::format("{} processes are too many for the parts of {} ranks: use at most {}", processes, ranks, ranks));
  }
}

RankPrediction predict_ranks(bodies::PreparedMeshes& prepared, int ranks, const StepMeasurement& measured,
                             const Network& network, MPI_Comm communicator) {
  const bodies::Preparation& ready = prepared.ready;
  const MemoryEstimate& memory = measured.memory;
  const Rates rates = rates_of(ready, measured.step, communicator);
  const bool in_parts = !prepared.rows.empty();
  const double peak_in_parts = loop::peak_memory();
  double elsewhere = memory.of_bodies(ready.part);  // what rank 0 holds of bodies, and will not, bytes
  RankPrediction result;
  result.network = network;
  result.halo = motion::halo_of(ready.scene);
  std::vector<RankStep> steps;
  for_each_part(
      prepared, ranks,
      [&](const mesh::Part& part) {
        const mesh::PartSize size = mesh::size_of(part);
        result.largest = mesh::largest(result.largest, size);
        result.memory = std::max(result.memory, memory.of(part));
        elsewhere -= steps.empty() ? memory.of_bodies(part) : 0.0;
        const double inner =
            result.halo == motion::Halo::states ? 0.0 : rates.unit_of_work * motion::work_without_ghosts(part);
        steps.push_back({.computing = rates.unit_of_work * size.work + rates.node * size.nodes,
                         .inner = inner,
                         .received = messages_of(part, result.halo)});
      },
      communicator);
  result.largest = largest(result.largest, communicator);
  result.memory = parallel::largest(result.memory, communicator);
  result.steps = {.steps_per_full_wait = ready.steps_per_read, .ranks = gathered(steps, communicator)};
  result.step = step_time(result.steps, network);
  result.speed_up =
      (rates.unit_of_work * work_of_all(ready) + rates.node * ready.offsets.nodes.back()) / result.step.whole;
  constexpr double of_files = 16e6 - saved_by_open_mpi;  // what a run holds besides: 11 to 21 MB with Open MPI 4
  const bool needs_all = !ready.initial_state.displacement.empty();    // for a static equilibrium
  const double peak = in_parts ? peak_in_parts : loop::peak_memory();  // METIS's work is rank 0's in a run, too
  result.root_memory = std::max(result.memory, peak + of_files - (needs_all ? 0.0 : elsewhere));
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
