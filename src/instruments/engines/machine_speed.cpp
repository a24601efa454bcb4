// How fast this machine computes sound maps.

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numbers>
#include <vector>

#include "idiophone/instruments/engines/engine_stage.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "stage_checks.hpp"

namespace idiophone::engines {

namespace {

/// A triangle that rings for long and radiates alike in all directions.
SharedMap triangle(std::size_t modes) {
  sound_maps::SoundMap map;
  map.mass = 0.1;
  map.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
  map.triangles = {{0, 1, 2}};
  map.sphere.rings = 1;
  map.sphere.azimuths = 1;
  map.sphere.direction = {Vector3::UnitZ()};
  map.sphere.weight = {4.0 * std::numbers::pi};
  map.sphere.pressure.assign(modes, {1.0, 0.5});
  map.material_decay.assign(modes, 1e-3);
  map.radiation_decay.assign(modes, 0.0);
  map.shape.assign(9 * modes, 1.0F);
  for (std::size_t mode = 0; mode < modes; ++mode) {
    map.frequency.push_back(500.0 * (1.0 + static_cast<double>(mode)));
  }
  return std::make_shared<const sound_maps::SoundMap>(std::move(map));
}

/// How long some work takes, s: as time passes or as processor time, whichever is less. The one counts while other
/// programs have the processor, the other what other threads of this one do.
template <class Work>
double time_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  const std::clock_t processor = std::clock();
  work();
  const double used = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;  // 0 on a coarse clock
  const double passed = std::chrono::duration<double>(Clock::now() - begin).count();
  return used > 0.0 ? std::min(used, passed) : passed;
}

}  // namespace

double measured_speed() {
  constexpr int rate = 48000, frames = 480, blocks = 25;
  constexpr std::int32_t bodies = 128;  // so many that they have to share the caches
  constexpr std::size_t modes = 32;
  constexpr double unlimited = 1e9;  // a budget that suffices for everything, of which costs are told
  EngineStage stage({.rate = rate, .ears = {{-0.1, 0, 1}, {0.1, 0, 1}}, .latency = 0.0, .budget = unlimited},
                    std::vector(bodies, triangle(modes)), {Surface{}});
  std::vector<double> sound(2UL * frames), times;
  for (int block = 0; block < blocks; ++block) {
    for (std::int32_t body = 0; body < bodies; ++body) {
      stage.place(static_cast<std::size_t>(body), {.position = {0.0, 0.0, 1e-3 * (block + body)}});
      if (block == 0) {
        stage.contact(
            {.contact = static_cast<std::uint64_t>(body), .bodies = {body, ContactEvent::nobody}, .impulse = 1e-3});
      }
    }
    stage.step(static_cast<double>(frames) / rate);
    times.push_back(time_of([&] { stage.render(sound); }));
  }
  constexpr int slow = 3 * blocks / 4;  // three quarters of the blocks take no longer
  std::ranges::nth_element(times, times.begin() + slow);
  return std::clamp(stage.report().cost * frames / (times[slow] * rate), least_speed, most_speed);
}

}  // namespace idiophone::engines
