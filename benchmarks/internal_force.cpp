// Elements per second of the internal force alone, on one core: a table-size plate and one of 100 thousand elements.

#include <benchmark/benchmark.h>

#include <cmath>

#include "block_mesh.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace {

using namespace idiophone;

void internal_force(benchmark::State& bench, element::Type element, int mechanisms, bool orthotropic = false) {
  const int side = static_cast<int>(bench.range(0));
  const mesh::Mesh plate = support::block_mesh(element, {0.3, 0.3, 0.006}, {side, side, 1});
  const mesh::Part part = support::whole_part(plate);
  scene::Material steel{"steel", 2e11, 0.3, 7850, {1, 1e-8}, {}};
  if (mechanisms > 0) {
    steel.damping.loss = {3e-4, {20, 20 * std::pow(10, mechanisms - 1)}, mechanisms, {}};
  }
  if (orthotropic) {
    steel.orthotropy = {Vector3::Constant(2e11), Vector3::Constant(0.3), Vector3::Constant(8e10)};
  }
  solid::Solid solid(part.bodies[0], part.reference, steel);
  solid.begin_memory(1e-7);
  std::vector<solid::NodeState> state(plate.nodes.size());
  std::vector<solid::NodeForce> force(plate.nodes.size());
  for (std::size_t node = 0; node < state.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      state[node].displacement[i] = 1e-6 * plate.nodes[node][(i + 1) % 3];
      state[node].velocity[i] = 1e-3 * plate.nodes[node][(i + 2) % 3];
    }
  }
  while (bench.KeepRunning()) {
    solid.add_internal_force_and_remember(state, force);
    benchmark::DoNotOptimize(force.data());
  }
  bench.counters["elements"] = plate.element_count();
  bench.counters["elements/s"] =
      benchmark::Counter(static_cast<double>(plate.element_count()), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

// The loss factor's memory: 3 mechanisms, for two decades of frequency.
BENCHMARK_CAPTURE(internal_force, tet4, element::tet4, 0)->Arg(18)->Arg(130);
BENCHMARK_CAPTURE(internal_force, tet4_3_mechanisms, element::tet4, 3)->Arg(18)->Arg(130);
BENCHMARK_CAPTURE(internal_force, tet10, element::tet10, 0)->Arg(18)->Arg(30)->Arg(60)->Arg(130);
BENCHMARK_CAPTURE(internal_force, tet10_3_mechanisms, element::tet10, 3)->Arg(18)->Arg(30)->Arg(60)->Arg(130);
BENCHMARK_CAPTURE(internal_force, tet4_orthotropic, element::tet4, 0, true)->Arg(18)->Arg(130);
BENCHMARK_CAPTURE(internal_force, tet10_orthotropic, element::tet10, 0, true)->Arg(18)->Arg(130);
