// Modes that one core computes in real time at 48 kHz on a stage, as the plugin and `play` render it: bodies with a
// sound map, a stereo listener, blocks of 128 frames. After a blow on each body all modes ring.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "idiophone/instruments/voices/stage.hpp"

namespace {

using idiophone::Vector3;
namespace drivers = idiophone::drivers;
namespace score = idiophone::score;
namespace sound_maps = idiophone::sound_maps;
namespace voices = idiophone::voices;

constexpr int rate = 48000;
constexpr std::size_t frames = 128;

/// A triangle with so many modes, which radiate alike in all directions.
std::shared_ptr<const sound_maps::SoundMap> map_of(std::size_t modes) {
  auto map = std::make_shared<sound_maps::SoundMap>();
  map->vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
  map->triangles = {{0, 1, 2}};
  map->sphere.rings = 1;
  map->sphere.azimuths = 1;
  map->sphere.direction = {Vector3::UnitZ()};
  map->sphere.weight = {4.0 * std::numbers::pi};
  map->sphere.pressure.assign(modes, {1.0, 0.5});
  map->material_decay.assign(modes, 1e-3);
  map->radiation_decay.assign(modes, 0.0);
  map->shape.assign(9 * modes, 1.0F);
  for (std::size_t mode = 0; mode < modes; ++mode) {
    map->frequency.push_back(20.0 * std::pow(1000.0, static_cast<double>(mode) / static_cast<double>(modes)));
  }
  return map;
}

void ring(benchmark::State& state) {
  const auto bodies = static_cast<std::size_t>(state.range(0)), modes = static_cast<std::size_t>(state.range(1));
  idiophone::scene::Listener listener;
  listener.receivers = {{.channel = "left", .position = {-0.1, 0, 1}}, {.channel = "right", .position = {0.1, 0, 1}}};
  const voices::Audience audience(listener, rate);
  const std::vector maps(bodies, map_of(modes));
  std::vector<std::unique_ptr<voices::Voice>> voice;
  voice.push_back(std::make_unique<voices::SoundMapVoices>(maps, audience, rate));
  voices::Stage stage(audience, std::move(voice), 2, rate);
  const score::HammerBlow blow{.hammer = {.mass = 0.01, .hardness = 1e8, .speed = 1.0}};
  for (std::size_t body = 0; body < bodies; ++body) {
    stage.perform(drivers::event_of({.time = 0.0, .body = body, .action = blow}, 0, 0, rate));
  }
  std::vector<double> sound(2 * frames);
  for (int block = 0; block < rate / static_cast<int>(frames); ++block) {  // until the force is over
    stage.render(sound, 0);
  }
  while (state.KeepRunning()) {
    stage.render(sound, 0);
    benchmark::DoNotOptimize(sound.data());
  }
  state.counters["modes_in_real_time"] = benchmark::Counter(static_cast<double>(bodies * modes * frames) / rate,
                                                            benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(ring)->Args({1, 1000})->Args({1, 100000})->Args({40, 50})->Args({400, 50});
