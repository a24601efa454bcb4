// Nodes per second of spectral hexahedra on one core, motion gathered and central differences included: a plate in one
// layer, of straight and of curved elements, with and without damping.

#include <benchmark/benchmark.h>

#include <algorithm>

#include "block_mesh.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "idiophone/solids/solid/packed_hexahedra.hpp"
#include "laws.hpp"

namespace {

using namespace idiophone;
using solid::IsotropicElasticity;

enum class Shape { flat, curved };

constexpr IsotropicElasticity steel{1.2e11, 8e10};
constexpr solid::KelvinVoigt<IsotropicElasticity> kelvin_voigt{steel, 1e-8};
constexpr solid::Undamped<IsotropicElasticity> undamped{steel};

/// v_{n+1/2} = v_{n-1/2} + dt f_n/m, u_{n+1} = u_n + dt v_{n+1/2}
void advance(std::span<const double> inverse_mass, std::span<const solid::NodeForce> force,
             std::span<solid::NodeState> state) {
  constexpr double step = 1e-8;  // s
  for (std::size_t node = 0; node < state.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      state[node].velocity[i] += step * inverse_mass[node] * force[node].component[i];
      state[node].displacement[i] += step * state[node].velocity[i];
    }
  }
}

/// Elements along a side of the plate: the benchmark's argument.
template <class Law>
void hex_force(benchmark::State& bench, element::Type type, Shape shape, const Law& law) {
  const auto side = static_cast<int>(bench.range(0));
  mesh::Part plate = support::whole_part(support::block_mesh(type, {0.3, 0.3, 0.003}, {side, side, 1}));
  if (shape == Shape::curved) {
    for (Vector3& x : plate.reference) {
      x[2] += 0.1 * x[0] * x[0];
    }
  }
  const solid::PackedHexahedra elements(plate.bodies[0], plate.reference);
  std::vector<double> inverse_mass(plate.reference.size());
  elements.add_mass(7850, inverse_mass);
  std::ranges::for_each(inverse_mass, [](double& mass) { mass = 1 / mass; });
  std::vector<solid::NodeState> state(plate.reference.size());
  std::vector<solid::NodeForce> force(plate.reference.size());
  for (std::size_t node = 0; node < state.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      state[node].displacement[i] = 1e-6 * plate.reference[node][(i + 1) % 3];
    }
  }
  while (bench.KeepRunning()) {
    std::ranges::fill(force, solid::NodeForce{});
    elements.add_internal_force(law, state, force);
    advance(inverse_mass, force, state);
    benchmark::DoNotOptimize(state.data());
  }
  const auto nodes = static_cast<double>(plate.reference.size());
  bench.counters["nodes"] = nodes;
  bench.counters["nodes/s"] = benchmark::Counter(nodes, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK_CAPTURE(hex_force, 442_damped, element::hex(4, 2), Shape::flat, kelvin_voigt)->Arg(6)->Arg(16)->Arg(40);
BENCHMARK_CAPTURE(hex_force, 442_undamped, element::hex(4, 2), Shape::flat, undamped)->Arg(6)->Arg(16)->Arg(40);
BENCHMARK_CAPTURE(hex_force, 442_curved_damped, element::hex(4, 2), Shape::curved, kelvin_voigt)
    ->Arg(6)
    ->Arg(16)
    ->Arg(40);
BENCHMARK_CAPTURE(hex_force, 332_damped, element::hex(3, 2), Shape::flat, kelvin_voigt)->Arg(16);
BENCHMARK_CAPTURE(hex_force, 552_damped, element::hex(5, 2), Shape::flat, kelvin_voigt)->Arg(16);
BENCHMARK_CAPTURE(hex_force, 443_damped, element::hex(4, 3), Shape::flat, kelvin_voigt)->Arg(16);
BENCHMARK_CAPTURE(hex_force, 666_damped, element::hex(6, 6), Shape::flat, kelvin_voigt)->Arg(4);
