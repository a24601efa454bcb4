// Membranes whose eigenvalues are known.

#include "idiophone/solids/eigenmodes/membrane.hpp"

#include <gmock/gmock.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "long_verification.hpp"
#include "plane_bodies.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr double pi = std::numbers::pi;

/// Eigenvalues of -laplacian: (2 pi f)^2 with unit tension and density, 1/m2.
std::vector<double> eigenvalues(const mesh::PlaneRegion& region, double size, int count) {
  std::vector<double> values;
  for (const PlaneMode& mode :
       membrane_modes(mesh::mesh_region(region, size), {uniform(1), uniform(1)}, {.count = count, .up_to = {}})) {
    values.push_back(std::pow(2 * pi * mode.frequency, 2));
  }
  return values;
}

/// The roots of a function between two places, ascending, by steps and bisection.
std::vector<double> roots(const std::function<double(double)>& function, double from, double to, double step) {
  std::vector<double> found;
  for (double low = from; low < to; low += step) {
    double left = low, right = low + step;
    const bool sign = function(left) > 0;
    if (sign == (function(right) > 0)) {
      continue;
    }
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (left + right);
      (sign == (function(middle) > 0) ? left : right) = middle;
    }
    found.push_back(0.5 * (left + right));
  }
  return found;
}

/// Eigenvalues of -(T X')' + T kappa^2 X = lambda sigma X on 0 to 1 with X = 0 at both ends: by shooting with the
/// classical method of Runge and Kutta, for T = tension(x, 0) and sigma = density(x, 0).
std::vector<double> shot_eigenvalues(const Membrane& membrane, double kappa, double up_to) {
  const auto last_value = [&](double lambda) {
    constexpr int steps = 400;
    const auto change = [&](double x, const Eigen::Vector2d& state) -> Eigen::Vector2d {
      const double tension = membrane.tension(x, 0);
      return {state[1] / tension, (tension * kappa * kappa - lambda * membrane.density(x, 0)) * state[0]};
    };
    Eigen::Vector2d state(0, 1);  // X and T X'
    for (int i = 0; i < steps; ++i) {
      const double x = static_cast<double>(i) / steps, h = 1.0 / steps;
      const Eigen::Vector2d a = change(x, state);
      const Eigen::Vector2d b = change(x + h / 2, state + h / 2 * a);
      const Eigen::Vector2d c = change(x + h / 2, state + h / 2 * b);
      state += h / 6 * (a + 2 * b + 2 * c + change(x + h, state + h * c));
    }
    return state[0];
  };
  return roots(last_value, 1, up_to, 2);
}

ON_RANKS(1);

TEST(Membrane, OfASquare) {
  const auto found = eigenvalues(inside({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), 0.05, 6);  // clockwise
  const std::vector<double> exact = {2, 5, 5, 8, 10, 10};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(found[i] / (pi * pi * exact[i]), 1, 5e-5) << i;
  }
  const auto finer = eigenvalues(rectangle(1, 1), 0.02, 3);
  EXPECT_NEAR(finer[0] / (2 * pi * pi), 1, 1e-6);
  EXPECT_NEAR(finer[2] / (5 * pi * pi), 1, 1e-6);
}

TEST(Membrane, OfADisc) {
  const auto found = eigenvalues(disc(2), 0.06, 6);
  const std::vector<double> roots = {2.404825557695773, 3.831705970207512, 3.831705970207512,
                                     5.135622301840683, 5.135622301840683, 5.520078110286311};
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_NEAR(found[i] / std::pow(roots[i] / 2, 2), 1, i < 3 ? 1e-6 : 3e-6) << i;
  }
}

/// Three unit squares: Fox, Henrici and Moler 1967; the third mode has no singularity.
TEST(Membrane, OfThreeSquaresAroundACorner) {
  LONG_VERIFICATION();
  const auto found = eigenvalues(inside({{0, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, -1}, {0, -1}}), 0.03, 3);
  EXPECT_NEAR(found[0] / 9.6397238440219, 1, 1e-6);
  EXPECT_NEAR(found[1] / 15.197251926454343, 1, 1e-6);
  EXPECT_NEAR(found[2] / (2 * pi * pi), 1, 1e-6);
}

/// Roots of J_n(k a) Y_n(k b) = J_n(k b) Y_n(k a); all but those of n = 0 are double.
TEST(Membrane, OfARing) {
  std::vector<double> exact;
  for (const int n : {0, 1, 2, 3, 4}) {
    const auto product = [n](double k) {
      return std::cyl_bessel_j(n, k) * std::cyl_neumann(n, 2 * k) -
             std::cyl_bessel_j(n, 2 * k) * std::cyl_neumann(n, k);
    };
    for (const double root : roots(product, 1, 5, 0.05)) {
      exact.insert(exact.end(), n == 0 ? 1 : 2, root * root);
    }
  }
  std::ranges::sort(exact);
  mesh::PlaneRegion ring = disc(2);
  ring.holes = disc(1).contours();
  ring.outline.centre = ring.holes.front().centre = {3, -1};
  const auto found = eigenvalues(ring, 0.1, 6);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i] / exact[i], 1, 2e-5) << i;
  }
}

/// A hole whose corners are re-entrant: along a symmetry of the square, it is an L-shape with sides that are held and
/// free.
TEST(Membrane, WithASquareHoleConverges) {
  mesh::PlaneRegion region = rectangle(3, 3);
  region.holes = inside({{1, 1}, {1, 2}, {2, 2}, {2, 1}}).contours();
  const double coarse = eigenvalues(region, 0.2, 1)[0];
  const double fine = eigenvalues(region, 0.1, 1)[0];
  EXPECT_NEAR(coarse / fine, 1, 2e-4);
  EXPECT_GT(fine, 7) << "between a strip of width 1 and four unit squares";
  EXPECT_LT(fine, 2 * pi * pi);
}

TEST(Membrane, WithDensityAndTensionThatVary) {
  const Membrane membrane{.tension = [](double x, double /*y*/) { return 1 + x * x; },
                          .density = [](double x, double /*y*/) { return std::exp(-2 * x); }};
  std::vector<double> exact;
  for (const int half_waves : {1, 2, 3}) {
    const auto shot = shot_eigenvalues(membrane, half_waves * pi / 0.8, 600);
    exact.insert(exact.end(), shot.begin(), shot.end());
  }
  std::ranges::sort(exact);
  const auto modes = membrane_modes(mesh::mesh_region(rectangle(1, 0.8), 0.05), membrane, {.count = 5, .up_to = {}});
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_NEAR(std::pow(2 * pi * modes[i].frequency, 2) / exact[i], 1, 3e-4) << i;
  }
}

/// The middle of a disc, to 0.4 of its radius, is 9.765625 times as dense (Ramakrishna and Sondhi 1954): slopes and
/// values of J_n(3.125 k r) inside and of J_n(k r) and Y_n(k r) outside agree.
TEST(Membrane, OfATabla) {
  constexpr double middle = 0.4, ratio = 3.125;
  std::vector<double> exact;
  for (const int n : {0, 1, 2, 3}) {
    const auto slope = [n](const auto& function, double x) { return n / x * function(n, x) - function(n + 1, x); };
    const auto j = [](int order, double x) { return std::cyl_bessel_j(order, x); };
    const auto y = [](int order, double x) { return std::cyl_neumann(order, x); };
    const auto mismatch = [&](double k) {
      const double outside = j(n, k * middle) * y(n, k) - j(n, k) * y(n, k * middle);
      const double outside_slope = slope(j, k * middle) * y(n, k) - j(n, k) * slope(y, k * middle);
      return ratio * slope(j, ratio * k * middle) * outside - j(n, ratio * k * middle) * outside_slope;
    };
    for (const double root : roots(mismatch, 0.5, 6, 0.05)) {
      exact.insert(exact.end(), n == 0 ? 1 : 2, root);
    }
  }
  std::ranges::sort(exact);
  const Membrane tabla{.tension = uniform(1), .density = [](double x, double y) {
                         return x * x + y * y < middle * middle ? ratio * ratio : 1;
                       }};
  const auto modes = membrane_modes(mesh::mesh_region(disc(1), 0.05), tabla, {.count = 6, .up_to = {}});
  for (std::size_t i = 0; i < modes.size(); ++i) {
    EXPECT_NEAR(2 * pi * modes[i].frequency / exact[i], 1, 5e-3) << i;
  }
}

TEST(Membrane, HasUnitModalMassAndItsTension) {
  const mesh::PlaneMesh mesh = mesh::mesh_region(rectangle(1, 1), 0.1);
  const auto modes = membrane_modes(mesh, {.tension = uniform(50), .density = uniform(0.5)}, {.up_to = 12.0});
  ASSERT_EQ(modes.size(), 3) << "7.07 Hz and twice 11.2 Hz";
  EXPECT_NEAR(modes[0].frequency, std::sqrt(50 / 0.5 * 2) / 2, 1e-3);
  EXPECT_NEAR(*std::ranges::max_element(modes[0].shape), 2 / std::sqrt(0.5), 0.01);
  for (const mesh::RimEdge& edge : mesh.rim) {
    EXPECT_EQ(modes[0].shape[edge.ends[0]], 0);
    EXPECT_EQ(modes[0].shape[edge.middle], 0);
  }
}

TEST(Membrane, IsRefusedIfItsOutlineCrossesItselfOrItHasNoModes) {
  EXPECT_ANY_THROW((void)mesh::mesh_region(inside({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), 0.1));
  const mesh::PlaneMesh mesh = mesh::mesh_region(rectangle(1, 1), 0.3);
  EXPECT_ANY_THROW((void)membrane_modes(mesh, {uniform(1), uniform(1)}, {.up_to = 0.5}));
  EXPECT_ANY_THROW((void)membrane_modes(mesh, {uniform(1), uniform(1)}, {.count = 100000, .up_to = {}}));
}

}  // namespace
}  // namespace idiophone::eigenmodes
