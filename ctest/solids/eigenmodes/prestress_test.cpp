// Modes of prestressed bodies: strings and membranes against exact solutions, and what is refused.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

/// A clamped string by Euler and Bernoulli's theory: E I w'''' - T w'' + mass w.. = 0.
struct ClampedString {
  double length;   ///< m
  double bending;  ///< E I, N m2
  double tension;  ///< N
  double mass;     ///< kg/m

  /// What is zero at its eigenfrequencies w, 1/s (Fletcher, Journal of the Acoustical Society of America 36, 1964).
  /// With 1/cosh taken out, so that it stays finite.
  [[nodiscard]] double characteristic(double w) const {
    const double root = std::sqrt(tension * tension + 4 * bending * mass * w * w);
    const double a = std::sqrt((root - tension) / (2 * bending));
    const double b = std::sqrt((root + tension) / (2 * bending));
    return 2 * a * b * (1 / std::cosh(b * length) - std::cos(a * length)) +
           (b * b - a * a) * std::sin(a * length) * std::tanh(b * length);
  }

  /// The n-th frequency from 1 on, Hz: just above that of a string without stiffness.
  [[nodiscard]] double frequency(int n) const {
    // a L lies between n pi and (n + 1/2) pi, and w follows from a.
    const auto w_of = [&](double a) { return a * std::sqrt((tension + bending * a * a) / mass); };
    double low = n * std::numbers::pi / length;
    double high = (n + 0.5) * std::numbers::pi / length;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      const bool same_sign =
          std::signbit(characteristic(w_of(middle))) == std::signbit(characteristic(w_of(low * (1 + 1e-12))));
      (same_sign ? low : high) = middle;
    }
    return w_of(low) / (2 * std::numbers::pi);
  }

  /// The part of the energy of bending in all strain energy: d ln w^2/d ln (E I).
  [[nodiscard]] double share_of_bending(int n) const {
    ClampedString stiffer = *this;
    stiffer.bending *= 1.001;
    return 2 * std::log(stiffer.frequency(n) / frequency(n)) / std::log(1.001);
  }
};

double cents_between(double value, double reference) {
  return 1200 * std::log2(value / reference);
}

/// Modes that move along an axis, most of all.
std::vector<Mode> modes_along(int axis, const Modes& found) {
  std::vector<Mode> chosen;
  std::ranges::copy_if(found.modes, std::back_inserter(chosen), [&](const Mode& mode) {
    const auto all = Eigen::Map<const Eigen::Matrix3Xd>(mode.shape.data(), 3, std::ssize(mode.shape) / 3);
    return all.row(axis).squaredNorm() > 0.9 * all.squaredNorm();
  });
  return chosen;
}

/// Makes the cells between 0 and `length` smaller towards both ends: there by the factor `least`.
void shrink_towards_ends(mesh::Mesh& mesh, int axis, double length, double least) {
  for (Vector3& node : mesh.nodes) {
    const double phase = 2 * std::numbers::pi * node[axis] / length;
    node[axis] -= (1 - least) * std::sin(phase) * length / (2 * std::numbers::pi);
  }
}

/// Steel, 0.5 x 0.4 x 650 mm along z, held at both ends: they bend within some millimetres.
VibratingBody steel_string(double stress, int cells) {
  constexpr double length = 0.65;
  VibratingBody body = block(element::hex(2, 6), {0.0005, 0.0004, length}, {1, 1, cells});
  for (std::size_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const double z = body.mesh.nodes[node].z();
    if (z < 1e-9 || z > length - 1e-9) {
      body.mesh.groups[z < 1e-9 ? "near" : "far"].push_back(static_cast<Index>(node));
    }
  }
  shrink_towards_ends(body.mesh, 2, length, 0.15);
  body.fix("near");
  body.fix("far");
  body.scene.bodies[0].prestress.emplace().stress(2, 2) = stress;
  body.scene.materials[0].damping.stiffness = 1e-7;
  return body;
}

/// The same by theory.
ClampedString string_theory(double stress) {
  constexpr double area = 0.0005 * 0.0004;
  return {.length = 0.65, .bending = 2e11 * area * 0.0004 * 0.0004 / 12, .tension = stress * area, .mass = 7850 * area};
}

ON_RANKS(1);

TEST(Prestress, AStiffStringHasItsPartials) {
  constexpr double stress = 4e8;  // 80 N
  const std::vector<Mode> partials = modes_along(1, steel_string(stress, 8).find({.count = 14}));
  ASSERT_GE(partials.size(), 6U);
  for (int n = 1; n <= 6; ++n) {
    const Mode& partial = partials[static_cast<std::size_t>(n - 1)];
    EXPECT_NEAR(cents_between(partial.frequency, string_theory(stress).frequency(n)), 0, 1) << "partial " << n;
    // Only its bending is damped.
    const double w = 2 * std::numbers::pi * partial.frequency;
    EXPECT_NEAR(partial.damping_ratio / (1e-7 * w / 2), string_theory(stress).share_of_bending(n),
                0.05 * string_theory(stress).share_of_bending(n));
  }
}

/// Its clamped edges bend within sqrt(D/T), by which each of them makes it shorter, to first order.
TEST(Prestress, AThinMembraneHasItsModes) {
  constexpr double stress = 2e5;
  constexpr double thickness = 0.0001;
  const Vector3 size(0.3, 0.2, thickness);
  VibratingBody body = block(element::hex(6, 2), size, {4, 3, 1});
  shrink_towards_ends(body.mesh, 0, size.x(), 0.01);
  shrink_towards_ends(body.mesh, 1, size.y(), 0.01);
  body.fix("rim");
  body.scene.materials = {{"latex", 1e6, 0.3, 1000, {0, 0}, {}}};
  body.scene.bodies[0].prestress.emplace().stress.diagonal() = Vector3(stress, stress, 0);
  const std::vector<Mode> modes = modes_along(2, body.find({.count = 14}));
  const double edge = thickness * std::sqrt(1e6 / (12 * (1 - 0.3 * 0.3) * stress));
  std::vector<double> exact;
  for (int m = 1; m < 8; ++m) {
    for (int n = 1; n < 8; ++n) {
      exact.push_back(std::sqrt(stress / 1000) / 2 * std::hypot(m / (size.x() - 2 * edge), n / (size.y() - 2 * edge)));
    }
  }
  std::ranges::sort(exact);
  ASSERT_GE(modes.size(), 10U);
  for (std::size_t m = 0; m < 10; ++m) {
    EXPECT_NEAR(cents_between(modes[m].frequency, exact[m]), 0, 1) << "mode " << m;
  }
}

TEST(Prestress, AColumnBucklesWhereEulerSays) {
  const double critical =
      4 * std::numbers::pi * std::numbers::pi * string_theory(0).bending / (0.65 * 0.65) / (0.0005 * 0.0004);
  EXPECT_THAT(steel_string(-1.02 * critical, 4).refusal({.count = 1}),
              testing::HasSubstr("buckles under its prestress"));
}

/// The lowest six partials of a body that is held like the string, as those of a string under a stress.
/// @param tolerance  cents
void expect_partials(VibratingBody& body, double stress, double tolerance = 1.0) {
  const std::vector<Mode> partials = modes_along(1, body.find({.count = 14}));
  ASSERT_GE(partials.size(), 6U);
  for (int n = 1; n <= 6; ++n) {
    const double frequency = partials[static_cast<std::size_t>(n - 1)].frequency;
    EXPECT_NEAR(cents_between(frequency, string_theory(stress).frequency(n)), 0, tolerance) << "partial " << n;
  }
}

/// Free sides give way to a pull across them. Along the string, which can't become shorter, this takes Poisson's part.
TEST(Prestress, AStressOnFreeFacesRelaxes) {
  VibratingBody body = steel_string(4e8, 8);
  body.scene.bodies[0].prestress->stress(0, 0) = 1e8;
  expect_partials(body, 4e8 - body.scene.materials[0].poisson * 1e8);
}

/// The clamps hold its sides. So it becomes shorter beside them, and the rest tauter.
TEST(Prestress, AStringThatCooledDownIsTaut) {
  VibratingBody body = steel_string(0.0, 8);
  body.scene.materials[0].expansion = 1e-5;
  body.scene.bodies[0].prestress->temperature = -200;
  expect_partials(body, body.scene.materials[0].young * 1e-5 * 200, 1.5);
}

/// Green's strain is e + e^2/2.
TEST(Prestress, AStringIsStretchedByItsEnd) {
  constexpr double strain = 0.002;
  VibratingBody body = steel_string(0.0, 8);
  body.scene.bodies[0].prestress->stretch = {.group = "far", .displacement = {0, 0, strain * 0.65}};
  expect_partials(body, body.scene.materials[0].young * (strain + strain * strain / 2));
}

TEST(Prestress, WhatNothingHoldsHasNoRest) {
  VibratingBody body = block(element::hex(2, 2), {0.1, 0.01, 0.01}, {2, 1, 1});
  body.scene.bodies[0].prestress.emplace().stress(0, 0) = 1e6;
  EXPECT_THAT(body.refusal({.count = 1}), testing::HasSubstr("deforms a body that nothing holds"));
}

}  // namespace
}  // namespace idiophone::eigenmodes
