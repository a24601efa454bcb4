// A blow on the map of a body against the run of the same blow on the same mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <regex>

#include "command_line.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/sound_reader.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::app {
namespace {

using support::Folder;

constexpr int rate = 44100;
constexpr std::size_t first = 300;  // sample after the blows: free bodies move on, which is no sound of a mode

/// Sum of products of two sounds, the second one shifted by some samples.
double product(const std::vector<double>& a, const std::vector<double>& b, int shift = 0) {
  double sum = 0.0;
  for (std::size_t i = first; i + 10 < a.size(); ++i) {
    sum += a[i] * b[i + shift];
  }
  return sum;
}

/// Level of one sound over that of another, dB.
double decibels(const std::vector<double>& one, const std::vector<double>& other) {
  return 10 * std::log10(product(one, one) / product(other, other));
}

/// What makes two sounds differ.
struct Difference {
  double level = 0.0;  ///< of the second over the first, dB
  double shift = 0.0;  ///< by which the second one is late, s
};

/// The shift is that of the largest correlation, interpolated by a parabola.
Difference difference(const std::vector<double>& a, const std::vector<double>& b) {
  int best = 0;
  for (int shift = -8; shift <= 8; ++shift) {
    best = product(a, b, shift) > product(a, b, best) ? shift : best;
  }
  const double before = product(a, b, best - 1);
  const double at = product(a, b, best);
  const double after = product(a, b, best + 1);
  return {decibels(b, a), (best + 0.5 * (before - after) / (before - 2 * at + after)) / rate};
}

constexpr double tap_duration = 2e-4;  // s

/// A clamped plate and a free bar beside it, both struck, and two microphones.
constexpr const char* deck_text = R"(
name: struck
time: {duration: 0.06}
materials:
  alloy: {young: 7.0e10, poisson: 0.33, density: 2700, damping: {mass: 10, stiffness: 2.0e-8}}
bodies:
  plate: {mesh: SOURCE/meshes/square_plate.geo, parameters: {side: 0.2, thickness: 0.01, size: 0.03}, fixed: [rim],
          material: alloy, element: tet10}
  bar: {mesh: SOURCE/meshes/bar.geo, parameters: {length: 0.3, width: 0.04, thickness: 0.02, size: 0.03},
        position: [0, 0.5, 0], material: alloy, element: tet10}
loads:
  tap: {body: plate, at: [0.04, 0.03, 0.005], force: [0, 0, -20], duration: 2.0e-4}
  tick: {body: bar, at: [0.01, 0.51, 0.01], force: [0, 0, -20], duration: 2.0e-4}
listeners:
  above: {type: mono, position: [0.1, 0.2, 0.7]}
  beside: {type: mono, position: [0.9, 0.1, 0.2]}
radiation: {model: kirchhoff, visibility: off}
audio: {rate: 44100, dc_block: 0}
output: {frames_per_second: 0, motion_per_second: 0}
)";

/// The sound of a half-sine blow of 20 N at a listener. A run has no radiation loss.
std::vector<double> rings(sound_maps::SoundMap map, const Vector3& at, std::size_t listener, std::size_t samples) {
  std::ranges::fill(map.radiation_decay, 0.0);
  const sound_maps::Blow blow{
      .at = at,
      .direction = -Vector3::UnitZ(),
      .force = [](double time) { return 20 * std::sin(std::numbers::pi * time / tap_duration); },
      .duration = tap_duration};
  return sound_maps::sound_of(blow, map, listener, rate, samples);
}

/// What a user would write after the name of the program.
void call_program(const std::string& arguments) {
  CommandLine line;
  line.parser().parse(arguments);
  ASSERT_EQ(call(line.command()), 0) << arguments;
}

ON_RANKS(1);

TEST(MapOfABody, RingsAsItsRun) {
  const Folder folder;
  const auto deck = folder / "struck.yaml";
  const std::string text = deck_text;
  std::ofstream(deck) << std::regex_replace(text, std::regex("SOURCE"), IDIOPHONE_SOURCE_DIR);
  const std::string files = fmt::format("{} --output-folder {}", deck.string(), folder.path().string());
  call_program("run " + files + " --progress log");
  call_program("map " + files + " --up-to 22000 --radiation kirchhoff");
  const sound_maps::SoundMap plate = sound_maps::read_sound_map(folder / "struck_plate.map.h5");
  const sound_maps::SoundMap bar = sound_maps::read_sound_map(folder / "struck_bar.map.h5");
  const auto sounds = results::read_sounds(folder / "struck.h5");
  ASSERT_EQ(sounds.size(), 2);
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    const std::vector<double>& ran = sounds[l].samples[0];
    std::vector<double> rang = rings(plate, {0.04, 0.03, 0.005}, l, ran.size());
    std::ranges::transform(rang, rings(bar, {0.01, 0.51, 0.01}, l, ran.size()), rang.begin(), std::plus());
    const auto [level, shift] = difference(ran, rang);
    EXPECT_NEAR(level, 0, 0.3) << sounds[l].name;
    EXPECT_NEAR(shift, 0, 1e-4) << sounds[l].name;
    std::vector<double> rest(ran.size());
    std::ranges::transform(ran, rang, rest.begin(), std::minus());
    EXPECT_LT(decibels(rest, ran), -20) << sounds[l].name;
  }
}

}  // namespace
}  // namespace idiophone::app
