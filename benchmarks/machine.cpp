// What one core of the machine can do: multiplications and additions in registers, and a triad of arrays in memory.
// The other benchmarks' rates are to be read against these.

#include <benchmark/benchmark.h>

#include <vector>

#include "idiophone/solids/solid/pack.hpp"

namespace {

using idiophone::solid::lanes;
using idiophone::solid::Pack;

void multiply_add(benchmark::State& bench) {
  constexpr int chains = 12;  // enough to hide the latency
  constexpr int rounds = 1000;
  Pack sum[chains] = {};
  Pack factor = Pack{} + 0.999;
  Pack term = Pack{} + 1e-3;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(term);
  while (bench.KeepRunning()) {
    for (int round = 0; round < rounds; ++round) {
      for (Pack& value : sum) {
        value = value * factor + term;
      }
    }
    benchmark::DoNotOptimize(sum);
  }
  bench.counters["flop/s"] =
      benchmark::Counter(2.0 * chains * rounds * lanes, benchmark::Counter::kIsIterationInvariantRate);
}

void triad(benchmark::State& bench) {
  const auto length = static_cast<std::size_t>(bench.range(0));
  std::vector<double> a(length, 0.0);
  const std::vector<double> b(length, 1.0);
  const std::vector<double> c(length, 2.0);
  while (bench.KeepRunning()) {
    for (std::size_t i = 0; i < length; ++i) {
      a[i] = b[i] + 3.0 * c[i];
    }
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  bench.counters["B/s"] = benchmark::Counter(3.0 * sizeof(double) * static_cast<double>(length),
                                             benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(multiply_add);
BENCHMARK(triad)->Arg(1 << 24);
