// Waves on a grid: cells per second of one core, in a cache and out of it, and the bytes that their pressures and rates
// are; benchmark_machine measures the bandwidth of the memory. The same on an accelerator: the environment variable
// IDIOPHONE_ACCELERATOR chooses it as the option --accelerator does (default: gpu).

#include <benchmark/benchmark.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "idiophone/air/waves/enclosing_box.hpp"
#include "idiophone/air/waves/surface_sources.hpp"
#include "idiophone/air/waves/velocity_history.hpp"
#include "idiophone/air/waves/wave_field.hpp"

namespace {

namespace waves = idiophone::waves;

/// MPI as long as the program runs.
class Mpi {
 public:
  Mpi() { MPI_Init(nullptr, nullptr); }
  ~Mpi() { MPI_Finalize(); }
  Mpi(const Mpi&) = delete;
  Mpi& operator=(const Mpi&) = delete;
  Mpi(Mpi&&) = delete;
  Mpi& operator=(Mpi&&) = delete;
};

void start_mpi() {
  static const Mpi mpi;
}

using idiophone::accelerator::Accelerator;

/// Steps of open air with absorbing layers: a cube of so many cells along each edge.
/// @param accelerator  null: the processor computes
void step_open_air(benchmark::State& state, Accelerator* accelerator) {
  start_mpi();
  const int edge = static_cast<int>(state.range(0));
  const waves::Grid grid{.cells = {edge, edge, edge}, .layer = static_cast<int>(state.range(1))};
  waves::WaveField field(waves::Division(grid, 1), waves::WaveField::largest_courant, MPI_COMM_SELF, {}, accelerator);
  field.set_pressure(field.subdomain().number({edge / 2, edge / 2, edge / 2}), 1.0F);
  while (state.KeepRunning()) {
    field.step({});
    benchmark::DoNotOptimize(field.pressure(0));  // waits for an accelerator
  }
  const double cells = static_cast<double>(edge) * edge * edge;
  state.counters["cells"] = benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes"] =
      benchmark::Counter(4.0 * sizeof(float) * cells, benchmark::Counter::kIsIterationInvariantRate);
}

/// A thin disc about the middle of a grid of cells of 1 m, in triangles of about a cell.
struct Disc {
  std::vector<std::array<idiophone::Index, 3>> triangles;
  std::vector<float> positions;

  Disc(double radius, double thickness, double middle) {
    const auto rings = static_cast<idiophone::Index>(radius), around = 6 * rings;
    for (const double height : {middle - thickness / 2.0, middle + thickness / 2.0}) {
      for (idiophone::Index ring = 0; ring <= rings; ++ring) {
        for (idiophone::Index step = 0; step < around; ++step) {
          const double angle = 2.0 * std::numbers::pi * step / around, r = radius * ring / rings;
          for (const double x : {middle + r * std::cos(angle), middle + r * std::sin(angle), height}) {
            positions.push_back(static_cast<float>(x));
          }
        }
      }
    }
    const auto add = [&](idiophone::Index a, idiophone::Index b, idiophone::Index c, idiophone::Index d) {
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    };
    const idiophone::Index top = (rings + 1) * around;
    for (idiophone::Index step = 0; step < around; ++step) {
      const idiophone::Index next = (step + 1) % around;
      for (idiophone::Index ring = 0; ring < rings; ++ring) {
        const idiophone::Index in = ring * around, out = in + around;
        add(in + step, in + next, out + next, out + step);
        add(top + in + step, top + out + step, top + out + next, top + in + next);
      }
      const idiophone::Index rim = rings * around;
      add(rim + step, rim + next, top + rim + next, top + rim + step);
    }
  }
};

/// Audio samples of the air around a disc that vibrates, in four steps each, and the air at the box after them: the
/// workload of a cymbal. As in a run, the box is needed when the next audio sample has begun.
void step_cymbal(benchmark::State& state, Accelerator* accelerator) {
  start_mpi();
  const int edge = static_cast<int>(state.range(0));
  constexpr int layer = 10, clearance = 5;
  const waves::Grid grid{.cell = 1.0, .cells = {edge, edge, edge}, .layer = layer};
  const Disc disc(edge / 2.0 - layer - clearance, 0.5, edge / 2.0 + 0.3);
  const waves::Obstruction obstruction{disc.triangles, disc.positions};
  waves::WaveField field(waves::Division(grid, 1), waves::WaveField::largest_courant, MPI_COMM_SELF, {}, accelerator);
  const waves::Subdomain& all = field.subdomain();
  waves::CutCells cells(all, obstruction, waves::WaveField::largest_courant);
  const waves::SurfaceSources sources(all, obstruction, disc.triangles.size(), cells,
                                      waves::WaveField::largest_courant);
  constexpr int steps = 4;
  waves::VelocityHistory velocities(disc.triangles.size(), steps);
  std::vector<float> newest(disc.triangles.size());
  field.set_surfaces(std::move(cells));
  constexpr int first = layer + 2;
  waves::EnclosingBox box(field, {{first, first, first}, {edge - first, edge - first, edge - first}});
  box.begin();
  while (state.KeepRunning()) {
    std::ranges::fill(newest, std::sin(static_cast<float>(state.iterations())));
    velocities.push(newest);
    for (int step = 0; step < steps; ++step) {
      field.step(sources, velocities, step);
    }
    benchmark::DoNotOptimize(box.finish().surface_pressure.data());
    box.begin();
  }
  const double count = static_cast<double>(edge) * edge * edge;
  state.counters["cells"] = benchmark::Counter(steps * count, benchmark::Counter::kIsIterationInvariantRate);
}

using Steps = void(benchmark::State& state, Accelerator* accelerator);

template <Steps steps>
void on_processor(benchmark::State& state) {
  steps(state, nullptr);
}

template <Steps steps>
void on_accelerator(benchmark::State& state) {
  try {
    const char* const wish = std::getenv("IDIOPHONE_ACCELERATOR");
    Accelerator accelerator(wish ? wish : "gpu");
    state.SetLabel(accelerator.name());
    steps(state, &accelerator);
  } catch (const std::runtime_error& error) {
    state.SkipWithError(error.what());
  }
}

}  // namespace

BENCHMARK(on_processor<step_cymbal>)->Arg(80);
BENCHMARK(on_accelerator<step_cymbal>)->Arg(80)->UseRealTime();
BENCHMARK(on_accelerator<step_open_air>)->Args({256, 0})->Args({256, 10})->UseRealTime();
BENCHMARK(on_processor<step_open_air>)->Args({64, 0})->Args({256, 0})->Args({64, 10})->Args({128, 10})->Args({256, 10});
