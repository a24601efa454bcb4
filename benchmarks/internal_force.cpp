// Elements per second of the internal force alone, on one core: a table-size plate and one of 100 thousand elements.

#include <benchmark/benchmark.h>

#include "block_mesh.hpp"
#include "idiophone/solid/solid.hpp"

namespace {

using namespace idiophone;

void internal_force(benchmark::State& bench, mesh::ElementType element) {
  const int side = static_cast<int>(bench.range(0));
  const mesh::Mesh plate = support::block_mesh(element, {0.3, 0.3, 0.006}, {side, side, 1});
  const mesh::Part part = support::whole_part(plate);
  const scene::Material steel{"steel", 2e11, 0.3, 7850, {1, 1e-8}, {}};
  const solid::Solid solid(part.bodies[0], part.reference, steel);
  std::vector<solid::NodeState> state(plate.nodes.size());
  std::vector<solid::NodeForce> force(plate.nodes.size());
  for (std::size_t node = 0; node < state.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      state[node].displacement[i] = 1e-6 * plate.nodes[node][(i + 1) % 3];
      state[node].velocity[i] = 1e-3 * plate.nodes[node][(i + 2) % 3];
    }
  }
  while (bench.KeepRunning()) {
    solid.add_internal_force(state.data(), force.data());
    benchmark::DoNotOptimize(force.data());
  }
  bench.counters["elements"] = plate.element_count();
  bench.counters["elements/s"] =
      benchmark::Counter(static_cast<double>(plate.element_count()), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK_CAPTURE(internal_force, tet4, mesh::ElementType::tet4)->Arg(18)->Arg(130);
BENCHMARK_CAPTURE(internal_force, tet10, mesh::ElementType::tet10)->Arg(18)->Arg(30)->Arg(60)->Arg(130);
