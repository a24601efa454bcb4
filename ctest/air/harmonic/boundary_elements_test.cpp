// Boundary elements against exact solutions.

#include "idiophone/air/harmonic/boundary_elements.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "vibrating_solid.hpp"

namespace idiophone::harmonic {
namespace {

using namespace radiation;  // the vibrating solids

using std::numbers::pi;
constexpr double body_radius = 0.1;  // m
const Vector3 oblique_axis = Vector3(1, 2, 2).normalized();

using Motion = std::function<Complex(const Vector3& place, const Vector3& normal)>;

Boundary boundary_of(const Solid& solid) {
  return {solid.vertices, solid.triangles};
}

std::vector<Complex> velocities(const Boundary& boundary, const Motion& motion) {
  std::vector<Complex> values;
  for (const auto& [a, b, c] : boundary.triangles) {
    const Vector3 first = boundary.vertices[a];
    const Vector3 normal = (boundary.vertices[b] - first).cross(boundary.vertices[c] - first).normalized();
    for (const Index vertex : {a, b, c}) {
      values.push_back(motion(boundary.vertices[vertex], normal));
    }
  }
  return values;
}

BoundaryField solve(const BoundaryElements& elements, double wave_number, const Motion& motion,
                    std::span<const PointSource> sources = {}) {
  const std::vector<std::vector<Complex>> all = {velocities(elements.boundary(), motion)};
  return elements.solve(wave_number, all, sources).front();
}

Complex pressure(const BoundaryElements& elements, const BoundaryField& field, const Vector3& point) {
  return elements.pressure_at(field, std::span(&point, 1)).front();
}

double along_axis(const Vector3&, const Vector3& normal) {
  return normal.dot(oblique_axis);
}

double outward(const Vector3&, const Vector3&) {
  return 1.0;
}

double nothing(const Vector3&, const Vector3&) {
  return 0.0;
}

double decibels(Complex one, Complex other) {
  return 20.0 * std::log10(std::abs(one / other));
}

/// Spherical Hankel function of the second kind.
Complex hankel(int order, double x) {
  const Complex wave = std::exp(Complex(0.0, -x));
  Complex before = wave / x;
  Complex now = Complex(0.0, 1.0) / x * wave;
  for (int l = 0; l < order; ++l) {
    before = std::exchange(now, (2.0 * l + 1.0) / x * now - before);
  }
  return now;
}

Complex hankel_slope(int order, double x) {
  return hankel(order, x) * (static_cast<double>(order) / x) - hankel(order + 1, x);
}

/// Pressure on the axis of a sphere whose normal velocity is a Legendre polynomial.
Complex of_sphere(int order, double ka, double distance) {
  return Complex(0.0, -quiet_air.impedance()) * hankel(order, ka * distance / body_radius) / hankel_slope(order, ka);
}

class Sphere : public testing::TestWithParam<double> {
 protected:
  static const BoundaryElements& elements() {
    static const BoundaryElements fine(boundary_of(icosphere(body_radius, 5)), quiet_air);
    return fine;
  }
  [[nodiscard]] static double wave_number() { return GetParam() / body_radius; }
};

TEST(AbsorbingAir, WeakensWhatIsFarAway) {
  const BoundaryElements elements(boundary_of(icosphere(body_radius, 2)), quiet_air);
  const BoundaryField field = solve(elements, 10.0, outward);
  const std::vector<Vector3> point = {20.0 * oblique_axis};
  const double ratio = std::abs(elements.pressure_at(field, point, 0.01)[0] / elements.pressure_at(field, point)[0]);
  EXPECT_NEAR(ratio, std::exp(-0.2), 0.001);
}

// pi and 4.4934 are resonances of the air inside a sphere, where the integral equation alone has many solutions.
INSTANTIATE_TEST_SUITE_P(, Sphere, testing::Values(0.05, 0.5, 1.5, pi, 4.4934, 7.0, 10.0));

TEST_P(Sphere, IsHeardAsItPulsatesOrOscillates) {
  const auto both = [&] {
    return std::vector{velocities(elements().boundary(), outward), velocities(elements().boundary(), along_axis)};
  }();
  const auto fields = elements().solve(wave_number(), both);
  for (const int order : {0, 1}) {
    const double power =
        2.0 * pi * body_radius * body_radius / (2.0 * order + 1.0) * of_sphere(order, GetParam(), body_radius).real();
    EXPECT_NEAR(fields[order].power / power, 1.0, 0.02);
    for (const double distance : {1.5 * body_radius, 1.0}) {
      const Complex heard = pressure(elements(), fields[order], distance * oblique_axis);
      const Complex exact = of_sphere(order, GetParam(), distance);
      EXPECT_NEAR(decibels(heard, exact), 0.0, 0.1);
      EXPECT_NEAR(std::arg(heard / exact), 0.0, 0.035);
    }
  }
}

TEST_P(Sphere, ScattersAPointSource) {
  // p_scattered = i k sum (2l + 1) j_l'(ka)/h_l'(ka) h_l(k r_s) h_l(k r) P_l: source and receiver on rays 60 degrees
  // apart
  const PointSource source{.position = 4.0 * body_radius * oblique_axis, .strength = 1.0};
  const Vector3 across = oblique_axis.unitOrthogonal();
  const Vector3 receiver = 3.0 * body_radius * (0.5 * oblique_axis + std::sqrt(0.75) * across);
  Complex exact = 0.0;
  for (int l = 0; l < 12 + static_cast<int>(2.0 * GetParam()); ++l) {
    const double slope = std::sph_bessel(l, GetParam()) * l / GetParam() - std::sph_bessel(l + 1, GetParam());
    exact += Complex(0.0, wave_number()) * (2.0 * l + 1.0) * slope / hankel_slope(l, GetParam()) *
             hankel(l, 4.0 * GetParam()) * hankel(l, 3.0 * GetParam()) * std::legendre(l, 0.5);
  }
  const auto field = solve(elements(), wave_number(), nothing, std::span(&source, 1));
  const Complex heard = pressure(elements(), field, receiver);
  EXPECT_NEAR(std::abs(heard - exact) / std::abs(exact), 0.0, 0.05);
}

TEST(BoundaryElements, ConvergeWithTheSquareOfTheCells) {
  const auto error = [](int n) {
    const BoundaryElements elements(boundary_of(icosphere(body_radius, n)), quiet_air);
    const auto field = solve(elements, 2.0 / body_radius, along_axis);
    const Complex exact = of_sphere(1, 2.0, 0.3);
    return std::abs(pressure(elements, field, 0.3 * oblique_axis) - exact) / std::abs(exact);
  };
  const double coarse = error(2), fine = error(4), finest = error(8);
  EXPECT_GT(coarse, 3.2 * fine);
  EXPECT_GT(fine, 3.2 * finest);
}

/// The field of point sources within bodies, as the bodies' motion sends it out.
double error_of_inner_sources(const Boundary& boundary, double wave_number, std::span<const PointSource> sources,
                              const Vector3& receiver) {
  const BoundaryElements elements(boundary, quiet_air);
  const auto field_of = [&](const Vector3& point, const Vector3& direction) {
    Complex slope = 0.0;
    Complex value = 0.0;
    for (const PointSource& source : sources) {
      const Vector3 way = point - source.position;
      const double r = way.norm();
      const Complex p = source.strength * std::polar(1.0 / r, -wave_number * r);
      value += p;
      slope -= p * Complex(1.0 / r, wave_number) * way.dot(direction) / r;
    }
    return std::pair(value, slope / Complex(0.0, -wave_number * quiet_air.impedance()));
  };
  const auto field =
      solve(elements, wave_number, [&](const Vector3& x, const Vector3& n) { return field_of(x, n).second; });
  return decibels(pressure(elements, field, receiver), field_of(receiver, oblique_axis).first);
}

TEST(BoundaryElements, HoldForACube) {
  const auto cube = boundary_of(box({0.2, 0.2, 0.2}, {6, 6, 6}));
  const std::vector<PointSource> sources = {{{0.02, 0.01, -0.02}, 1.0}, {{-0.03, 0.0, 0.01}, {0.0, -0.7}}};
  for (const double wave_number : {1.0, 10.0, 20.0}) {
    const double error = error_of_inner_sources(cube, wave_number, sources, {0.15, 0.2, 0.3});
    EXPECT_NEAR(error, 0.0, 0.25) << wave_number;
  }
}

TEST(BoundaryElements, HoldForTwoBodies) {
  Boundary both = boundary_of(icosphere(0.06, 5));
  const Solid other = box({0.1, 0.1, 0.1}, {6, 6, 6});
  const auto first = static_cast<Index>(both.vertices.size());
  for (const Vector3& vertex : other.vertices) {
    both.vertices.emplace_back(vertex + Vector3(0.13, 0.0, 0.0));
  }
  for (const auto& [a, b, c] : other.triangles) {
    both.triangles.push_back({first + a, first + b, first + c});
  }
  const std::vector<PointSource> sources = {{{0.01, 0.0, 0.0}, 1.0}, {{0.13, 0.01, 0.0}, {0.0, 1.0}}};
  for (const double wave_number : {1.0, 15.0}) {
    const double error = error_of_inner_sources(both, wave_number, sources, {0.1, 0.3, 0.2});
    EXPECT_NEAR(error, 0.0, 0.2) << wave_number;
  }
}

TEST(BoundaryElements, AreReciprocal) {
  const BoundaryElements elements(boundary_of(box({0.3, 0.2, 0.01}, {12, 8, 1})), quiet_air);
  const Vector3 here(0.05, 0.02, 0.1), there(0.2, -0.1, -0.3);
  const auto scattered = [&](const Vector3& from, const Vector3& to) {
    const PointSource source{.position = from, .strength = 1.0};
    return pressure(elements, solve(elements, 25.0, nothing, std::span(&source, 1)), to);
  };
  const Complex forth = scattered(here, there), back = scattered(there, here);
  EXPECT_LT(std::abs(forth / back - 1.0), 0.01);
}

/// A disc of the given thickness over its radius that moves along its axis, against the added mass of a thin one,
/// (8/3) rho a^3 (Lamb 1932), at low frequencies.
double error_of_oscillating_disc(double thickness, int n) {
  constexpr double ka = 0.1, distance = 3.0;
  const BoundaryElements elements(boundary_of(disc(body_radius, n, thickness * body_radius)), quiet_air);
  const auto field =
      solve(elements, ka / body_radius, [](const Vector3&, const Vector3& normal) { return normal.z(); });
  const double near = std::hypot(1.0, body_radius / (ka * distance));
  const double exact = 2.0 / (3.0 * pi) * quiet_air.impedance() * ka * ka * body_radius / distance * near;
  return decibels(pressure(elements, field, {0, 0, distance}), exact);
}

TEST(BoundaryElements, HoldForAThinDiscThatOscillates) {
  EXPECT_NEAR(error_of_oscillating_disc(0.002, 8), 0.0, 0.15);
  // It also displaces air: 3 pi/8 times the thickness, of the added mass; and edges that are thicker carry more along.
  EXPECT_NEAR(error_of_oscillating_disc(0.05, 6), 0.75, 0.2);
}

/// The part of a solid above z = 0 on a rigid floor there, without what lies in the floor.
Boundary upper_half(const Solid& solid) {
  Boundary half{{}, {}, radiation::ReflectingPlane{}};
  std::vector<Index> numbers(solid.vertices.size(), -1);
  for (auto triangle : solid.triangles) {
    double sum = 0.0;
    for (const Index vertex : triangle) {
      sum += solid.vertices[vertex].z();
    }
    if (sum <= 1e-9) {
      continue;
    }
    for (Index& vertex : triangle) {
      if (numbers[vertex] < 0) {
        numbers[vertex] = static_cast<Index>(half.vertices.size());
        half.vertices.push_back(solid.vertices[vertex]);
      }
      vertex = numbers[vertex];
    }
    half.triangles.push_back(triangle);
  }
  return half;
}

/// A piston in a rigid wall: a flat drum on the floor, without a bottom, whose top moves.
TEST(Floor, MakesABaffledPistonOfADrum) {
  Solid drum = disc(body_radius, 8, 0.01 * body_radius);
  for (Vector3& vertex : drum.vertices) {
    vertex.z() += 0.005 * body_radius;
  }
  const BoundaryElements elements(upper_half(drum), quiet_air);
  for (const double ka : {0.2, 2.0, 5.0}) {
    const double k = ka / body_radius;
    const auto field = solve(elements, k, [](const Vector3&, const Vector3& n) { return std::max(0.0, n.z()); });
    for (const double z : {0.05, 0.2, 1.0}) {
      const double exact = 2.0 * quiet_air.impedance() * std::abs(std::sin(k / 2.0 * (std::hypot(z, body_radius) - z)));
      EXPECT_NEAR(decibels(pressure(elements, field, {0, 0, z}), exact), 0.0, 0.2) << ka << " at " << z;
    }
    const double power =
        0.5 * quiet_air.impedance() * pi * body_radius * body_radius * (1.0 - std::cyl_bessel_j(1, 2.0 * ka) / ka);
    EXPECT_NEAR(field.power / power, 1.0, 0.04) << ka;
  }
}

TEST(Floor, MakesAHemisphereAWholeSphere) {
  const BoundaryElements hemisphere(upper_half(sphere(body_radius, 6)), quiet_air),
      whole(boundary_of(sphere(body_radius, 6)), quiet_air);
  const Vector3 point(0.1, 0.05, 0.2);
  for (const double ka : {0.1, 1.0, pi}) {
    const auto half_field = solve(hemisphere, ka / body_radius, outward),
               field = solve(whole, ka / body_radius, outward);
    EXPECT_LT(std::abs(pressure(hemisphere, half_field, point) / pressure(whole, field, point) - 1.0), 1e-5);
    const auto far = [&](const BoundaryElements& elements, const BoundaryField& of) {
      return elements.far_field(of, std::span(&oblique_axis, 1)).front();
    };
    EXPECT_LT(std::abs(far(hemisphere, half_field) / far(whole, field) - 1.0), 1e-5);
    EXPECT_NEAR(half_field.power / field.power, 0.5, 1e-5);
  }
}

TEST(BoundaryElements, RefuseWhatIsNoBoundary) {
  const Boundary cube = boundary_of(box({0.1, 0.1, 0.1}, {1, 1, 1}));
  const auto refuse = [&](const std::function<void(Boundary&)>& spoil) {
    Boundary boundary = cube;
    spoil(boundary);
    EXPECT_THROW(BoundaryElements(boundary, quiet_air), std::invalid_argument)
        << boundary.triangles.size() << " triangles, " << boundary.vertices.size() << " vertices, "
        << boundary.triangles.front()[0];
  };
  refuse([](Boundary& b) { b.triangles.clear(); });
  refuse([](Boundary& b) { b.triangles[0][0] = 8; });
  refuse([](Boundary& b) { b.triangles[0][0] = b.triangles[0][1]; });
  refuse([](Boundary& b) { b.vertices[0].x() = std::nan(""); });
  refuse([](Boundary& b) { b.vertices.emplace_back(1, 1, 1); });
  refuse([](Boundary& b) { b.floor = radiation::ReflectingPlane{}; });
  const BoundaryElements elements(cube, quiet_air);
  const std::vector<std::vector<Complex>> short_one = {std::vector<Complex>(3)};
  EXPECT_THROW((void)elements.solve(1.0, short_one), std::invalid_argument);
  EXPECT_THROW((void)elements.solve(0.0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::harmonic
