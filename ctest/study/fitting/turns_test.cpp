// The turns of a material's axes in its body, from lines that the program computed with them.

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

#include "bars.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {
namespace {

/// A crystal, along the axes of its block.
scene::Material crystal(scene::Symmetry symmetry, const std::vector<double>& constants) {
  scene::Material material{"crystal", 0, 0, 2330, {}, {}};
  material.crystal = {symmetry, constants};
  material.young = scene::constants_along_axes(material)->young.maxCoeff();
  return material;
}

const scene::Material silicon = crystal(scene::Symmetry::cubic, {165.7e9, 63.9e9, 79.6e9});

/// A block with three different sides.
scene::Scene block(const scene::Material& material) {
  scene::Scene scene = bar_scene({0.03, 0.025, 0.02}, 0.015, 4);
  scene.materials = {material};
  return scene;
}

TurnedMaterial turned(const scene::Material& material, const Vector3& turns) {
  TurnedMaterial result = material;
  result.turns = turns;
  return result;
}

Measurements lines_of_turned(const scene::Scene& scene, const TurnedMaterial& material, int count, double cents) {
  StrainedBody body(scene, eigenmodes::MassMatrix::consistent);
  const Eigen::VectorXd frequencies = body.lowest(material, count + 2).frequencies(material);
  Measurements measured;
  for (Eigen::Index m = 0; m < std::min<Eigen::Index>(count, frequencies.size()); ++m) {
    const double moved = cents * std::sin(1.7 * static_cast<double>(m * m));
    measured.lines.push_back({.frequency = frequencies[m] * std::exp2(moved / 1200), .uncertainty = 2});
  }
  return measured;
}

void print(const Identification& found) {
  for (const IdentifiedConstant& c : found.constants) {
    std::printf("%s %g +- %g %d\n", c.name.c_str(), c.value, c.half_width, c.determined);
  }
  for (const Vector3& t : found.equivalent_turns) {
    std::printf("equivalent %g %g %g\n", t[0], t[1], t[2]);
  }
  for (const auto& d : found.doubts) std::printf("%s\n", d.c_str());
  std::printf("rms %g solves %d\n", found.fitted_rms.value_or(-1), found.solves);
}

ON_RANKS(1);

TEST(Turns, Try) {
  for (const Vector3& turns : {Vector3(0, 0, 5), Vector3(0, 0, 0)}) {
    scene::Material guess = silicon;
    guess.crystal->constants = {150e9, 70e9, 72e9};
    const Measurements measured = lines_of_turned(block(silicon), turned(silicon, turns), 25, 1);
    std::printf("---- %g %g %g\n", turns[0], turns[1], turns[2]);
    print(identify(block(guess), measured, {.constants = {"constants", "turns"}}));
  }
}

TEST(Turns, Try2) {
  for (const Vector3& turns : {Vector3(5, -8, 12), Vector3(15, 10, 20)}) {
    scene::Material guess = spruce();
    guess.orthotropy->young = {11e9, 0.98e9, 0.53e9};
    guess.orthotropy->shear = {0.72e9, 0.038e9, 0.7e9};
    const Measurements measured = lines_of_turned(block(spruce()), turned(spruce(), turns), 40, 1);
    std::printf("---- %g %g %g\n", turns[0], turns[1], turns[2]);
    print(identify(block(guess), measured, {.constants = {"constants", "turns"}}));
  }
}
TEST(Turns, Try3) {
  const scene::Material magnesium = crystal(scene::Symmetry::hexagonal, {59.7e9, 26.2e9, 21.7e9, 61.7e9, 16.4e9});
  const scene::Material composite = crystal(scene::Symmetry::hexagonal, {14e9, 7e9, 6e9, 140e9, 5e9});
  for (const auto& m : {magnesium, composite}) {
  for (const Vector3& turns : {Vector3(5, -8, 12), Vector3(15, 10, 20)}) {
    scene::Material guess = m;
    for (double& c : guess.crystal->constants) c *= 0.93;
    guess.crystal->constants[4] *= 1.1;
    const Measurements measured = lines_of_turned(block(m), turned(m, turns), 30, 1);
    std::printf("---- %g %g %g\n", turns[0], turns[1], turns[2]);
    print(identify(block(guess), measured, {.constants = {"constants", "turns"}}));
  }
  }
}
TEST(Turns, Try4) {
  scene::Scene plate = bar_scene({0.3, 0.1, 0.004}, 0.05, 4);
  plate.materials = {spruce()};
  for (const double angle : {5., 20., 0.}) {
    const Measurements measured = lines_of_turned(plate, turned(spruce(), {0, 0, angle}), 15, 1);
    scene::Scene guess = plate;
    guess.materials[0].orthotropy->young = {11e9, 0.98e9, 0.53e9};
    guess.materials[0].orthotropy->shear = {0.72e9, 0.038e9, 0.7e9};
    std::printf("---- %g\n", angle);
    print(identify(guess, measured, {.constants = {"young_x", "young_y", "shear_xy", "poisson_xy", "turn_z"}}));
  }
}

}  // namespace
}  // namespace idiophone::fitting
