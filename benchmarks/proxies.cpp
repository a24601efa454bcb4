// Mass-spring proxies on one core: springs per second of the spring forces alone, and of a proxy with its masses,
// memory and sound.

#include <benchmark/benchmark.h>

#include <memory>

#include "idiophone/instruments/proxies/engine.hpp"
#include "spring_packs.hpp"

namespace {

namespace proxies = idiophone::proxies;
using idiophone::Vector3;

/// A cube of 10 cm.
std::shared_ptr<const proxies::Lattice> cube(const std::array<int, 3>& cells) {
  const auto place = [](const Vector3& at) { return Vector3(0.1 * at); };
  return std::make_shared<proxies::Lattice>(
      proxies::grid_mesh(cells, place),
      proxies::Material{.young = 1e6, .density = 1000.0, .damping = {.mass = 1.0, .stiffness = 1e-6}});
}

void spring_forces(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const auto lattice = cube({cells, cells, cells});
  const proxies::SpringPacks springs(*lattice);
  proxies::Rows displacement(proxies::padded_rows(lattice->masses().size())), force(displacement.size());
  for (std::size_t i = 0; i < lattice->masses().size(); ++i) {
    displacement[i] = proxies::row_of(1e-6 * Vector3::Random());
  }
  while (state.KeepRunning()) {
    springs.add_forces(displacement, force);
    benchmark::DoNotOptimize(force.data());
  }
  state.counters["springs"] =
      benchmark::Counter(static_cast<double>(lattice->springs().size()), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["in_full_packs"] =
      static_cast<double>(lattice->springs().size()) / static_cast<double>(springs.packs() * proxies::springs_in_pack);
}

void whole_proxy(benchmark::State& state) {
  const int cells = static_cast<int>(state.range(0));
  const auto lattice = cube({cells, cells, cells});
  proxies::Proxy proxy(lattice, {.significant_distance = 1e-30});
  const proxies::PointForce blow{.contact = lattice->contact_at({0.03, 0.06, 0.1}), .force = {0.0, 0.0, -1.0}};
  proxy.advance({&blow, 1});
  double sound = 0.0;
  while (state.KeepRunning()) {
    proxy.advance({});
    sound += proxy.facing_volume_velocity();
    benchmark::DoNotOptimize(sound);
  }
  state.counters["springs"] = benchmark::Counter(static_cast<double>(lattice->springs().size()) * proxy.steps(),
                                                 benchmark::Counter::kIsIterationInvariantRate);
}

/// Seconds of sound per second of 64 bodies of 294 masses, so many of which sound, with one step in an audio sample.
void engine_of_64(benchmark::State& state) {
  const auto lattice = cube({6, 6, 5});
  proxies::Engine engine({.significant_distance = 1e-30, .most_active = 64});
  for (int body = 0; body < 64; ++body) {
    engine.add({.name = "cube", .levels = {lattice}});
  }
  for (int body = 0; body < state.range(0); ++body) {
    engine.add(proxies::impact(static_cast<std::size_t>(body), 0, {0.03, 0.06, 0.1}, {0.0, 0.0, -1e-3}, 1e-3, 44100));
  }
  std::vector<double> block(128);
  while (state.KeepRunning()) {
    engine.render(block);
  }
  state.counters["seconds_per_second"] =
      benchmark::Counter(static_cast<double>(block.size()) / 44100, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

BENCHMARK(spring_forces)->Arg(3)->Arg(6)->Arg(16);
BENCHMARK(whole_proxy)->Arg(3)->Arg(6)->Arg(16);
BENCHMARK(engine_of_64)->Arg(0)->Arg(1)->Arg(8);
