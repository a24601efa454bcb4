#include <gmock/gmock.h>
#include <random>
#include <cstdio>
#include "bars.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "ranks.hpp"
#include "strained_body.hpp"
namespace idiophone::fitting {
namespace {
ON_RANKS(1);
TEST(ZZ, Random) {
  std::mt19937 generator(37);
  std::uniform_real_distribution<double> angle(-25, 25), factor(0.9, 1.1);
  for (int k = 0; k < 8; ++k) {
    const scene::Material m = spruce();
    TurnedMaterial guess = m;
    for (const auto& c : elastic_constants(m)) c.in(guess) *= factor(generator);
    TurnedMaterial truth = m;
    truth.turns = Vector3(angle(generator), angle(generator), angle(generator));
    if (!is_stable(guess)) continue;
    scene::Scene scene = bar_scene({0.03, 0.025, 0.02}, 0.015, 4);
    scene.materials = {m};
    StrainedBody body(scene, eigenmodes::MassMatrix::consistent);
    const Eigen::VectorXd f = body.lowest(truth, 42).frequencies(truth);
    Measurements measured;
    for (int i = 0; i < 40; ++i) measured.lines.push_back({.frequency = f[i] * std::exp2(std::sin(1.7 * i * i) / 1200), .uncertainty = 2});
    scene.materials = {guess};
    const Identification found = identify(scene, measured, {.constants = {"constants", "turns"}});
    std::printf("---- %d: %g %g %g: %g %g %g rms %g solves %d\n", k, truth.turns[0], truth.turns[1], truth.turns[2], found.constants[9].value, found.constants[10].value, found.constants[11].value, found.fitted_rms.value_or(-1), found.solves);
    fflush(stdout);
  }
}
}
}
