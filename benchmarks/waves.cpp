// Waves on a grid: cells per second of one core, and the memory bandwidth beside them, in a cache and out of it.

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
  state.counters["cells"] =
      benchmark::Counter(static_cast<double>(edge) * edge * edge, benchmark::Counter::kIsIterationInvariantRate);
}

/// a = b + s c in floats: bytes per second.
void triad(benchmark::State& state) {
  const auto length = static_cast<std::size_t>(state.range(0));
  std::vector<float> a(length), b(length, 1.0F), c(length, 2.0F);
  while (state.KeepRunning()) {
    for (std::size_t i = 0; i < length; ++i) {
      a[i] = b[i] + 0.5F * c[i];
    }
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] = benchmark::Counter(3.0 * sizeof(float) * static_cast<double>(length),
                                               benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(step)->Args({64, 0})->Args({256, 0})->Args({64, 10})->Args({128, 10})->Args({256, 10});
BENCHMARK(triad)->Arg(1 << 26);
