// Waves on a grid: cells per second of one core, in a cache and out of it, and the bytes that their pressures and rates
// are; benchmark_machine measures the bandwidth of the memory.

#include <benchmark/benchmark.h>
#include <mpi.h>

#include "idiophone/waves/wave_field.hpp"

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

/// Steps of open air with absorbing layers: a cube of so many cells along each edge.
void step(benchmark::State& state) {
  static const Mpi mpi;
  const int edge = static_cast<int>(state.range(0));
  const waves::Grid grid{.cells = {edge, edge, edge}, .layer = static_cast<int>(state.range(1))};
  waves::WaveField field(waves::Slab(grid, 0, edge), waves::WaveField::largest_courant, MPI_COMM_SELF);
  field.set_pressure(field.slab().number(edge / 2, edge / 2, edge / 2), 1.0F);
  while (state.KeepRunning()) {
    field.step({});
  }
  const double cells = static_cast<double>(edge) * edge * edge;
  state.counters["cells"] = benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes"] =
      benchmark::Counter(4.0 * sizeof(float) * cells, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(step)->Args({64, 0})->Args({256, 0})->Args({64, 10})->Args({128, 10})->Args({256, 10});
