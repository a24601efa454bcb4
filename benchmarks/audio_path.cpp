// What the way from the surface's motion to the accumulation buffers costs, in ns per triangle and audio sample (and
// per receiver where it is radiated): a waving sheet, six reads an audio sample.

#include <benchmark/benchmark.h>

#include <cmath>

#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/air/receivers/accumulation_buffer.hpp"
#include "idiophone/air/surface/emitter.hpp"
#include "idiophone/air/surface/surface.hpp"

namespace {

using idiophone::Index;
using idiophone::Vector3;
namespace receivers = idiophone::receivers;
namespace radiation = idiophone::radiation;
namespace surface = idiophone::surface;

/// A square sheet of about so many triangles, 0.3 m wide, at work.
class Sheet {
 public:
  explicit Sheet(std::int64_t triangles)
      : cells_(static_cast<Index>(std::lround(std::sqrt(static_cast<double>(triangles) / 2.0)))),
        surface_(make_triangles(), make_vertices(), {.steps_per_sample = 24, .steps_per_read = 4}),
        emitter_(make_triangles(), 0.0) {
    emitter_.start(surface_.start());
  }

  void read() {
    const auto displacements = surface_.displacements();
    for (std::size_t i = 0; i < displacements.size(); ++i) {
      displacements[i] = 1e-6 * static_cast<double>((i * 7 + reads_) % 64);
    }
    ++reads_;
    surface_.read();
  }

  const surface::Emission& sample() {
    for (int i = 0; i < surface_.sampling().reads_per_sample(); ++i) {
      read();
    }
    surface_.take(motion_);
    emitter_.emit(motion_, emission_);
    return emission_;
  }

  [[nodiscard]] double triangles() const { return static_cast<double>(surface_.triangles()); }

 private:
  [[nodiscard]] std::vector<std::array<Index, 3>> make_triangles() const {
    std::vector<std::array<Index, 3>> triangles;
    for (Index corner = 0; corner < cells_ * (cells_ + 1); ++corner) {
      if (corner % (cells_ + 1) < cells_) {
        triangles.push_back({corner, corner + 1, corner + cells_ + 2});
        triangles.push_back({corner, corner + cells_ + 2, corner + cells_ + 1});
      }
    }
    return triangles;
  }

  [[nodiscard]] std::vector<Vector3> make_vertices() const {
    std::vector<Vector3> vertices;
    vertices.reserve(static_cast<std::size_t>(cells_ + 1) * (cells_ + 1));
    for (Index row = 0; row <= cells_; ++row) {
      for (Index column = 0; column <= cells_; ++column) {
        vertices.emplace_back(0.3 * column / cells_, 0.3 * row / cells_, 0.0);
      }
    }
    return vertices;
  }

  Index cells_;
  surface::Surface surface_;
  surface::SurfaceMotion motion_;
  surface::Emitter emitter_;
  surface::Emission emission_;
  std::size_t reads_ = 0;
};

/// Prints seconds per triangle and iteration: "17n" is 17 ns.
void count(benchmark::State& state, const Sheet& sheet) {
  state.counters["per_triangle"] = benchmark::Counter(
      sheet.triangles(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Writing displacements alone, as the other numbers contain it.
void write(benchmark::State& state) {
  Sheet sheet(state.range(0));
  std::vector<double> row(3 * static_cast<std::size_t>(sheet.triangles() / 2.0));
  std::size_t reads = 0;
  while (state.KeepRunning()) {
    for (int read = 0; read < 6; ++read, ++reads) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = 1e-6 * static_cast<double>((i * 7 + reads) % 64);
      }
      benchmark::DoNotOptimize(row.data());
      benchmark::ClobberMemory();
    }
  }
  count(state, sheet);
}

void read_and_emit(benchmark::State& state) {
  Sheet sheet(state.range(0));
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(sheet.sample().pressure.data());
  }
  count(state, sheet);
}

const radiation::ReceiverState receiver{.position = {0.1, 0.15, 1.0}};

void radiate(const surface::Emission& emission, radiation::Paths& paths, radiation::Arrivals& arrivals) {
  radiation::find_paths(emission, receiver, {}, paths);
  radiation::Huygens().radiate(emission, paths, arrivals);
}

void radiate_huygens(benchmark::State& state) {
  Sheet sheet(state.range(0));
  const surface::Emission& emission = sheet.sample();
  radiation::Paths paths;
  radiation::Arrivals arrivals;
  while (state.KeepRunning()) {
    radiate(emission, paths, arrivals);
    benchmark::DoNotOptimize(arrivals.sound.data());
  }
  count(state, sheet);
}

void add(benchmark::State& state, const Sheet& sheet, const radiation::Arrivals& arrivals,
         const receivers::Spreading& spreading) {
  receivers::AccumulationBuffer buffer(spreading.first(), 1e6, spreading);
  std::int64_t sample = 0;
  while (state.KeepRunning()) {
    buffer.add(sample, arrivals);
    if (++sample % 256 == 0) {
      benchmark::DoNotOptimize(buffer.take(256).data());
    }
  }
  count(state, sheet);
}

void add_splat(benchmark::State& state) {
  Sheet sheet(state.range(0));
  radiation::Paths paths;
  radiation::Arrivals arrivals;
  radiate(sheet.sample(), paths, arrivals);
  add(state, sheet, arrivals, receivers::Spreading::splat());
}

void add_band_limited(benchmark::State& state) {
  Sheet sheet(state.range(0));
  radiation::Paths paths;
  radiation::Arrivals arrivals;
  const surface::Emission& emission = sheet.sample();
  radiation::find_paths(emission, receiver, {}, paths);
  radiation::Kirchhoff({}).radiate(emission, paths, arrivals);
  add(state, sheet, arrivals, receivers::Spreading::band_limited());
}

}  // namespace

BENCHMARK(write)->Arg(1372)->Arg(300000);
BENCHMARK(read_and_emit)->Arg(1372)->Arg(300000);
BENCHMARK(radiate_huygens)->Arg(1372)->Arg(300000);
BENCHMARK(add_splat)->Arg(1372)->Arg(300000);
BENCHMARK(add_band_limited)->Arg(1372)->Arg(300000);
