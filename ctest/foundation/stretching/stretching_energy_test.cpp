#include "idiophone/foundation/stretching/stretching_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::stretching {
namespace {

/// Numbers without pattern from -1 to 1, of which the pairs of modes have some zeros.
struct Body {
  static constexpr std::size_t modes = 21, terms = 11;
  std::vector<double> linear, quadratic = std::vector<double>(terms * modes * modes);

  Body() {
    for (std::size_t i = 0; i < terms * modes; ++i) {
      linear.push_back(std::sin(1.3 * static_cast<double>(i * i)));
    }
    for (std::size_t n = 0; n < terms; ++n) {
      for (std::size_t i = 0; i < modes; ++i) {
        for (std::size_t j = i; j < modes; ++j) {
          const bool none = (n + i + j) % 3 != 0;
          at(n, i, j) = at(n, j, i) = none ? 0.0 : std::sin(0.7 * static_cast<double>(n * n + 5 * i * j));
        }
      }
    }
  }

  double& at(std::size_t n, std::size_t i, std::size_t j) { return quadratic[(n * modes + i) * modes + j]; }

  /// The sum itself, in double precision.
  double energy(const std::vector<double>& q, double bend) {
    double energy = 0.0;
    for (std::size_t n = 0; n < terms; ++n) {
      double a = 0.0, z = 0.0;
      for (std::size_t i = 0; i < modes; ++i) {
        a += bend * linear[n * modes + i] * q[i];
        for (std::size_t j = 0; j < modes; ++j) {
          z += q[i] * at(n, i, j) * q[j];
        }
      }
      energy += z * (a + z / 2);
    }
    return energy;
  }
};

TEST(StretchingEnergy, IsTheSumOfItsTerms) {
  Body body;
  StretchingEnergy energy(body.linear, body.quadratic, Body::modes);
  std::vector<float> places, gradient(Body::modes);
  std::vector<double> q;
  for (std::size_t i = 0; i < Body::modes; ++i) {
    q.push_back(std::cos(2.1 * static_cast<double>(i)));
    places.push_back(static_cast<float>(q.back()));
  }
  const double expected = body.energy(q, 1.4);
  EXPECT_NEAR(energy.at(places, 1.4F, gradient), expected, 1e-5 * std::abs(expected));
  for (std::size_t i = 0; i < Body::modes; ++i) {
    std::vector<double> more = q, less = q;
    more[i] += 1e-4;
    less[i] -= 1e-4;
    const double slope = (body.energy(more, 1.4) - body.energy(less, 1.4)) / 2e-4;
    EXPECT_NEAR(gradient[i], slope, 1e-4 * (1 + std::abs(slope))) << i;
  }
  EXPECT_LT(energy.operations(), 2 * Body::terms * Body::modes * (Body::modes + 1)) << "zeros cost nothing";
}

}  // namespace
}  // namespace idiophone::stretching
