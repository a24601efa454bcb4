// Potentials of a panel against each other: closed forms, quadrature, and what they do at the panel.

#include "panel.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

#include "galerkin.hpp"
#include "idiophone/air/harmonic/sphere_rule.hpp"

namespace idiophone::harmonic {
namespace {

using namespace radiation;  // the vibrating solids

const Panel panel({Vector3(0.1, 0, 0), Vector3(0.5, 0.2, 0.1), Vector3(0, 0.6, 0.2)});

/// By the rule of degree 5 on 4^cuts pieces.
LayerPotentials fine_potentials(const Vector3& point, double wave_number, int cuts) {
  LayerPotentials sum;
  const std::function<void(const Eigen::Matrix3d&, int)> add = [&](const Eigen::Matrix3d& piece, int left) {
    if (left > 0) {
      const Vector3 a = piece.col(0), b = piece.col(1), c = piece.col(2);
      const Vector3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
      for (const auto& part :
           {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}}) {
        Eigen::Matrix3d columns;
        columns << part[0], part[1], part[2];
        add(columns, left - 1);
      }
      return;
    }
    const Panel small({panel.at(piece.col(0)), panel.at(piece.col(1)), panel.at(piece.col(2))});
    const auto potentials = quadrature_potentials(small, point, wave_number, triangle_rule_5());
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 3; ++c) {
        sum.single_layer[b] += piece(b, c) * potentials.single_layer[c];
        sum.double_layer[b] += piece(b, c) * potentials.double_layer[c];
      }
    }
  };
  add(Eigen::Matrix3d::Identity(), cuts);
  return sum;
}

TEST(Panel, HasTheSamePotentialsInClosedFormAndByQuadrature) {
  for (const Vector3& point : {Vector3(0.3, 0.3, 0.3), Vector3(0.9, -0.1, 0.2), Vector3(0.2, 0.2, -0.1)}) {
    const auto near = near_potentials(panel, point, 1.0);
    const auto fine = fine_potentials(point, 1.0, 5);
    for (int b = 0; b < 3; ++b) {
      EXPECT_LT(std::abs(near.single_layer[b] - fine.single_layer[b]), 5e-4 * std::abs(fine.single_layer[b]));
      EXPECT_LT(std::abs(near.double_layer[b] - fine.double_layer[b]), 2e-3 * std::abs(fine.double_layer[b]) + 1e-5);
    }
  }
}

TEST(Panel, HasADoubleLayerThatJumpsByOneHalfAtEachSide) {
  const auto sum_at = [](double height) {
    const auto potentials = near_potentials(panel, panel.at({0.3, 0.3, 0.4}) + height * panel.normal, 3.0);
    return (potentials.double_layer[0] + potentials.double_layer[1] + potentials.double_layer[2]).real();
  };
  EXPECT_NEAR(sum_at(1e-6), 0.5, 1e-4);
  EXPECT_NEAR(sum_at(-1e-6), -0.5, 1e-4);
  EXPECT_NEAR(sum_at(0.0), 0.0, 1e-12);
  EXPECT_NEAR(sum_at(1e-17), 0.0, 1e-12);  // as rounding leaves it
}

TEST(Panel, SeesItsImageAsTheImageSeesIt) {
  const radiation::ReflectingPlane plane{.at = {0, 0, -0.3}, .normal = Vector3(0.1, -0.2, 1).normalized()};
  const Panel image = mirrored(panel, plane);
  const Vector3 point(0.2, 0.5, 0.4);
  const Vector3 mirrored_point = plane.at + plane.mirrored(point - plane.at);
  const auto here = near_potentials(panel, point, 5.0), there = near_potentials(image, mirrored_point, 5.0);
  for (int b = 0; b < 3; ++b) {
    EXPECT_LT(std::abs(here.single_layer[b] - there.single_layer[b]), 1e-12);
    EXPECT_LT(std::abs(here.double_layer[b] - there.double_layer[b]), 1e-12);
  }
}

TEST(PanelPair, IsSymmetricInItsSingleLayer) {
  for (const double shift : {0.02, 0.3, 1.5, 6.0}) {
    std::array<Vector3, 3> places = panel.corners;
    for (Vector3& place : places) {
      place = place + shift * panel.normal + 0.2 * shift * Vector3::UnitX();
    }
    const Panel shifted(places);
    const PanelPair forth = panel_pair(panel, shifted, 2.0), back = panel_pair(shifted, panel, 2.0);
    EXPECT_LT((forth.single_layer - back.single_layer.transpose()).norm(), 2e-3 * forth.single_layer.norm()) << shift;
  }
}

TEST(TriangleRule, IntegratesPolynomialsOfItsDegree) {
  const auto integral = [](std::span<const TrianglePoint> rule, int i, int j) {
    double sum = 0.0;
    for (const TrianglePoint& q : rule) {
      sum += q.weight * std::pow(q.shape[0], i) * std::pow(q.shape[1], j);
    }
    return sum;
  };
  const auto exact = [](int i, int j) {
    return 2.0 * std::tgamma(i + 1) * std::tgamma(j + 1) / std::tgamma(i + j + 3);
  };
  for (int i = 0; i <= 5; ++i) {
    for (int j = 0; i + j <= 5; ++j) {
      EXPECT_NEAR(integral(triangle_rule_5(), i, j), exact(i, j), 1e-14) << i << " " << j;
      if (i + j <= 2) {
        EXPECT_NEAR(integral(triangle_rule_2(), i, j), exact(i, j), 1e-14) << i << " " << j;
      }
    }
  }
}

TEST(SphereRule, IntegratesHarmonics) {
  const SphereRule rule = sphere_rule(5);
  double one = 0.0, fourth = 0.0, mixed = 0.0;
  for (std::size_t d = 0; d < rule.directions.size(); ++d) {
    const Vector3& n = rule.directions[d];
    one += rule.weights[d];
    fourth += rule.weights[d] * std::pow(n.dot(Vector3(1, 2, 2) / 3.0), 8);
    mixed += rule.weights[d] * n.x() * n.z();
  }
  EXPECT_NEAR(one, 4 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(fourth, 4 * std::numbers::pi / 9, 1e-12);
  EXPECT_NEAR(mixed, 0.0, 1e-12);
}

}  // namespace
}  // namespace idiophone::harmonic
