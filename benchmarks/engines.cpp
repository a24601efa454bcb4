// Processor time of a stage for engines for a second of sound (docs/use/engines.md): a heap of plates that tremble.
// Each of them touches two others and the ground. There are two ears and 60 steps a second.

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace {

namespace engines = idiophone::engines;
namespace sound_maps = idiophone::sound_maps;
using idiophone::Vector3;
using std::numbers::pi;

constexpr int rate = 48000, steps_per_second = 60, frames = rate / steps_per_second;

/// A plate of 0.2 m and 1352 triangles with 31 modes, which radiate alike in 512 directions.
engines::SharedMap plate() {
  constexpr int cells = 26, modes = 31;
  sound_maps::SoundMap map;
  map.mass = 0.1;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      map.vertices.emplace_back(0.2 * i / cells - 0.1, 0.2 * j / cells - 0.1, 0.0);
      const idiophone::Index corner = j * (cells + 1) + i, above = corner + cells + 1;
      if (i < cells && j < cells) {
        map.triangles.push_back({corner, corner + 1, above});
        map.triangles.push_back({corner + 1, above + 1, above});
      }
    }
  }
  map.sphere.rings = 16;
  map.sphere.azimuths = 32;
  for (int i = 0; i < 512; ++i) {
    const double z = 1.0 - (2.0 * (i / 32) + 1.0) / 16.0, angle = pi * (i % 32) / 16.0, radius = std::sqrt(1.0 - z * z);
    map.sphere.direction.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  map.sphere.weight.assign(512, 4.0 * pi / 512.0);
  map.sphere.pressure.assign(512UL * modes, {1.0, 0.5});
  map.material_decay.assign(modes, 5.0);
  map.radiation_decay.assign(modes, 1.0);
  for (int mode = 0; mode < modes; ++mode) {
    map.frequency.push_back(800.0 + 600.0 * mode);
    for (const Vector3& vertex : map.vertices) {
      const double bend =
          6.0 * std::cos((1 + mode % 6) * 15.0 * vertex.x()) * std::cos((1 + mode / 6) * 15.0 * vertex.y());
      map.shape.insert(map.shape.end(), {0.0F, 0.0F, static_cast<float>(bend)});
    }
  }
  return std::make_shared<const sound_maps::SoundMap>(std::move(map));
}

class Heap {
 public:
  Heap(int bodies, double budget)
      : bodies_(bodies),
        stage_({.rate = rate, .ears = {{-0.1, -2, 1}, {0.1, -2, 1}}, .latency = 0.0, .budget = budget},
               std::vector(static_cast<std::size_t>(bodies), plate_), {engines::Surface{}}) {}

  void step() {
    for (int body = 0; body < bodies_; ++body) {
      stage_.place(static_cast<std::size_t>(body), {.position = {0.2 * (body % 8), 0.002 * tremble_(random_), 0.0}});
      tell(body, engines::ContactEvent::nobody);
      tell(body, (body + 1) % bodies_);
    }
    stage_.step(1.0 / steps_per_second);
  }

  void render(std::vector<float>& sound) { stage_.render(sound, 20.0); }

 private:
  void tell(int body, int other) {
    stage_.contact({.contact = static_cast<std::uint64_t>(2 * body + (other < 0 ? 1 : 0)),
                    .bodies = {body, other},
                    .point = {0.2 * (body % 8) + 0.03, 0.02, 0.0},
                    .impulse = 1e-4 * std::exp(1.5 * tremble_(random_)),
                    .slip = {0.02 * tremble_(random_), 0.0, 0.0}});
  }

  int bodies_;
  engines::SharedMap plate_ = plate();
  engines::EngineStage stage_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> tremble_;
};

/// With so many bodies, and so many hundredths of the processor's time as the budget; 0: without a limit.
void tremble(benchmark::State& state) {
  const double budget = state.range(1) > 0 ? 0.01 * static_cast<double>(state.range(1)) : 1e9;
  Heap heap(static_cast<int>(state.range(0)), budget);
  std::vector<float> sound(2UL * frames);
  std::clock_t control = 0, audio = 0;
  while (state.KeepRunning()) {
    const std::clock_t begin = std::clock();
    heap.step();
    const std::clock_t middle = std::clock();
    heap.render(sound);
    control += middle - begin;
    audio += std::clock() - middle;
  }
  const double scale = steps_per_second / static_cast<double>(CLOCKS_PER_SEC);
  state.counters["step"] = benchmark::Counter(scale * static_cast<double>(control), benchmark::Counter::kAvgIterations);
  state.counters["render"] = benchmark::Counter(scale * static_cast<double>(audio), benchmark::Counter::kAvgIterations);
}

}  // namespace

BENCHMARK(tremble)
    ->ArgsProduct({{40, 100, 300}, {20, 0}})
    ->ArgNames({"bodies", "budget"})
    ->Iterations(3 * steps_per_second)
    ->Unit(benchmark::kMillisecond);
