// Steps of finite elements on an accelerator: nodes per second. The environment variable IDIOPHONE_ACCELERATOR chooses
// it as the option --accelerator does (default: gpu).

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <stdexcept>

#include "block_mesh.hpp"
#include "idiophone/solids/accelerated/accelerated_solid.hpp"

namespace {

using namespace idiophone;
using accelerated::AcceleratedSolid;

enum class Shape { flat, curved };
enum class Damping { none, kelvin_voigt, loss_factor };

constexpr double step = 1e-8;  // s

scene::Material steel(Damping damping) {
  scene::Material material{"steel", 2e11, 0.3, 7850, {}, {}};
  if (damping == Damping::kelvin_voigt) {
    material.damping.stiffness = 1e-8;
  } else if (damping == Damping::loss_factor) {
    material.damping.loss = {0.001, {100, 20000}, {}, {}};
  }
  return material;
}

/// A plate of one layer of elements.
/// @param side  elements along it
mesh::Part plate(element::Type type, int side, Shape shape) {
  mesh::Part part = support::whole_part(support::block_mesh(type, {0.3, 0.3, 0.003}, {side, side, 1}));
  if (shape == Shape::curved) {
    for (Vector3& x : part.reference) {
      x[2] += 0.1 * x[0] * x[0];
    }
  }
  return part;
}

/// Elements along a side of the plate: the benchmark's argument.
void advance(benchmark::State& bench, element::Type type, Shape shape, Damping damping) {
  const mesh::Part part = plate(type, static_cast<int>(bench.range(0)), shape);
  const mesh::BodyPart& body = part.bodies[0];
  solid::Solid solid(body, part.reference, steel(damping));
  std::vector<double> masses(part.reference.size());
  solid.add_mass(masses);
  solid.begin_memory(step);
  const solid::Mass mass(body, masses);
  try {
    const char* const wish = std::getenv("IDIOPHONE_ACCELERATOR");
    accelerator::Accelerator accelerator(wish ? wish : "gpu");
    bench.SetLabel(accelerator.name());
    AcceleratedSolid there(accelerator, body, part.reference, solid, mass, {}, step);
    std::vector<solid::NodeState> state(part.reference.size());
    for (std::size_t node = 0; node < state.size(); ++node) {
      state[node].velocity[2] = part.reference[node][0];
    }
    there.load(state, solid);
    accelerated::NodeList one = there.list({0});
    constexpr int steps = 20;  // between two reads
    while (bench.KeepRunning()) {
      for (int i = 0; i < steps; ++i) {
        there.find_stress();
        there.advance({1.0, step, Vector3::Zero()}, AcceleratedSolid::Displacements::follow);
      }
      there.read(one, state);
    }
    const auto nodes = static_cast<double>(part.reference.size());
    bench.counters["nodes"] = nodes;
    bench.counters["nodes/s"] = benchmark::Counter(steps * nodes, benchmark::Counter::kIsIterationInvariantRate);
  } catch (const std::runtime_error& error) {
    bench.SkipWithError(error.what());
  }
}

void sides(benchmark::internal::Benchmark* bench) {
  bench->Arg(32)->Arg(144)->UseRealTime();  // 50 000 and a million nodes
}

}  // namespace

BENCHMARK_CAPTURE(advance, 442, element::hex(4, 2), Shape::flat, Damping::none)->Apply(sides);
BENCHMARK_CAPTURE(advance, 442_damped, element::hex(4, 2), Shape::flat, Damping::kelvin_voigt)->Apply(sides);
BENCHMARK_CAPTURE(advance, 442_curved, element::hex(4, 2), Shape::curved, Damping::none)->Apply(sides);
BENCHMARK_CAPTURE(advance, 442_curved_damped, element::hex(4, 2), Shape::curved, Damping::kelvin_voigt)->Apply(sides);
BENCHMARK_CAPTURE(advance, 442_loss_factor, element::hex(4, 2), Shape::flat, Damping::loss_factor)->Apply(sides);
BENCHMARK_CAPTURE(advance, tet10_curved_damped, element::tet10, Shape::curved, Damping::kelvin_voigt)
    ->Arg(100)
    ->UseRealTime();
