// Motion of a string of finite elements: energy, pitch that depends on the amplitude, and saved states.

#include <cmath>
#include <numbers>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

constexpr double string_length = 0.4;       // m
constexpr double string_thickness = 0.002;  // m
constexpr double string_stress = 5e4;       // Pa
constexpr double string_step = 3e-6;        // s

/// Rubber, 400 x 2 x 2 mm, held at both ends.
Laboratory rubber_string(element::Type type, const std::array<int, 3>& cells) {
  Laboratory lab(support::block_mesh(type, {string_length, string_thickness, string_thickness}, cells));
  lab.fix("x0");
  lab.fix("x1");
  lab.scene.bodies[0].prestress.emplace().stress(0, 0) = string_stress;
  return lab;
}

/// A string whose first mode begins at its turning point, stretched evenly along its length. Its cross-sections stay
/// normal to it, and are as narrow as the stretch makes them.
Laboratory deflected(double amplitude) {
  Laboratory lab = rubber_string(element::hex(4, 2), {8, 1, 1});
  lab.begin(string_step);
  const double wave_number = std::numbers::pi / string_length;
  const double stretch = std::pow(wave_number * amplitude / 2, 2);
  std::vector<double> rows;
  for (const Vector3& place : lab.mesh.nodes) {
    const double phase = wave_number * place.x();
    const double slope = std::atan(wave_number * amplitude * std::cos(phase));
    const Vector3 centre(place.x() - stretch / (2 * wave_number) * std::sin(2 * phase), string_thickness / 2,
                         string_thickness / 2 + amplitude * std::sin(phase));
    const Vector3 arm =
        (1 - 0.3 * stretch) * Vector3(0, place.y() - string_thickness / 2, place.z() - string_thickness / 2);
    const Vector3 moved = centre + Vector3(-std::sin(slope) * arm.z(), arm.y(), std::cos(slope) * arm.z()) - place;
    rows.insert(rows.end(), {moved.x(), moved.y(), moved.z(), 0, 0, 0});
  }
  lab.put(rows);
  return lab;
}

/// Part of the first mode in the present motion, m kg.
double first_mode(const Laboratory& lab) {
  const std::span<const double> masses = lab.motion->dynamics().model(0).masses();
  double sum = 0.0;
  for (std::size_t node = 0; node < masses.size(); ++node) {
    sum += masses[node] * std::sin(std::numbers::pi * lab.mesh.nodes[node].x() / string_length) *
           lab.displacement(node).z();
  }
  return sum;
}

/// Time until the first mode passes its place of rest, s: a quarter of a period.
double quarter_period(double amplitude) {
  const Laboratory lab = deflected(amplitude);
  double before = first_mode(lab);
  for (int steps = 1;; ++steps) {
    lab.advance(1);
    const double now = first_mode(lab);
    if (now < 0) {
      return string_step * (steps - now / (now - before));
    }
    before = now;
  }
}

ON_RANKS(1);

/// Kirchhoff's string (Vorlesungen ueber Mechanik, 1876): its tension grows by E A/(2 L) times the integral of w'^2, so
/// that w^2 grows by the factor 1 + 3 pi^2 E a^2/(16 S L^2), with S the stress at rest and a the amplitude.
TEST(Tension, GrowsWithTheAmplitudeOfAString) {
  constexpr double amplitude = 0.01;
  const double rise = std::pow(quarter_period(1e-5) / quarter_period(amplitude), 2) - 1;
  const double expected = 3 * std::numbers::pi * std::numbers::pi * 1e6 * amplitude * amplitude /
                          (16 * string_stress * string_length * string_length);
  EXPECT_NEAR(rise / expected, 1.0, 0.03);
}

TEST(Tension, ConservesEnergy) {
  Laboratory lab = deflected(0.02);
  const BodyMotion start = lab.observe();
  const double energy = start.kinetic + start.elastic;
  for (int sample = 0; sample < 20; ++sample) {
    lab.advance(400);
    const BodyMotion now = lab.observe();
    EXPECT_NEAR((now.kinetic + now.elastic) / energy, 1.0, 1e-3);
  }
  EXPECT_LT(lab.observe().elastic, 0.9 * energy) << "it vibrates";
}

TEST(Tension, LimitsTheStep) {
  Laboratory slack = rubber_string(element::hex(2, 2), {4, 1, 1});
  slack.scene.bodies[0].prestress.reset();
  Laboratory taut = rubber_string(element::hex(2, 2), {4, 1, 1});
  const auto step_of = [](Laboratory& lab) {
    lab.begin(string_step);
    return find_stable_steps(lab.part, lab.motion->dynamics())[0].step;
  };
  const double shear_modulus = 1e6 / 2.6;
  EXPECT_NEAR(step_of(slack) / step_of(taut), std::sqrt(1 + string_stress / shear_modulus), 1e-9);
}

class TautElements : public ::testing::TestWithParam<element::Type> {};

TEST_P(TautElements, GoOnFromASavedState) {
  Laboratory lab = rubber_string(GetParam(), {8, 1, 1});
  lab.scene.materials[0].damping.loss = {0.1, {50, 2000}, {}, {}};
  lab.scene.bodies[0].fixed.pop_back();
  lab.attachments.bodies[0].fixed.pop_back();
  lab.push("x1", {0, 0, 0.1}, 5e-3);
  expect_a_saved_state_to_go_on(lab, string_step, 30);
}

INSTANTIATE_TEST_SUITE_P(Elements, TautElements, ::testing::Values(element::tet4, element::tet10, element::hex(2, 2)));

}  // namespace
}  // namespace idiophone::motion
