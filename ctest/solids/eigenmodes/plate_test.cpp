// Thin plates against exact solutions and tables (Leissa 1969, Vibration of Plates; 1973). Frequency parameters are
// 2 pi f a^2 sqrt(sigma/D) for the side or the radius a: here, a, sigma and D are 1.

#include "idiophone/solids/eigenmodes/plate.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "plane_bodies.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr double pi_of_plates = std::numbers::pi;

using Edges = std::vector<PlateEdge>;
constexpr PlateEdge held_free = PlateEdge::free;
constexpr PlateEdge supported = PlateEdge::supported;
constexpr PlateEdge clamped = PlateEdge::clamped;

/// The lowest frequency parameters.
std::vector<double> parameters(const mesh::PlaneRegion& region, const std::vector<Edges>& edges, double poisson,
                               double size, int count, double tension = 0.0) {
  const Plate plate{.stiffness = 1, .poisson = poisson, .tension = tension, .density = 1, .edges = edges};
  std::vector<double> found;
  for (const PlaneMode& mode :
       plate_modes(region, mesh::mesh_region(region, size), plate, {.count = count, .up_to = {}})) {
    found.push_back(2 * pi_of_plates * mode.frequency);
  }
  return found;
}

/// Of a unit square: sides y = 0, x = 1, y = 1, x = 0.
std::vector<double> square(const Edges& edges, double poisson, double size, int count) {
  return parameters(rectangle(1, 1), {edges}, poisson, size, count);
}

void expect_ratios(const std::vector<double>& found, const std::vector<double>& exact, double tolerance) {
  ASSERT_EQ(found.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(found[i] / exact[i], 1, tolerance) << i << ": " << found[i];
  }
}

ON_RANKS(1);

TEST(Plate, OfASupportedRectangle) {
  const double unit = pi_of_plates * pi_of_plates / 4;
  const std::vector<double> exact = {5 * unit, 8 * unit, 13 * unit, 17 * unit, 20 * unit, 20 * unit};  // m^2 + 4 n^2
  for (const double poisson : {-0.5, 0.0, 0.45}) {
    expect_ratios(parameters(rectangle(2, 1), {Edges(4, supported)}, poisson, 0.15, 6), exact, 1e-3);
  }
}

TEST(Plate, ConvergesInTheFourthOrder) {
  const auto error = [](double size) {
    return square(Edges(4, supported), 0.3, size, 1)[0] / (2 * pi_of_plates * pi_of_plates) - 1;
  };
  const double coarse = error(0.1), fine = error(0.05);
  EXPECT_GT(fine, 0) << "conforming elements are too stiff";
  EXPECT_GT(std::log2(coarse / fine), 3.5) << coarse << " " << fine;
}

TEST(Plate, OfAClampedSquare) {
  expect_ratios(square(Edges(4, clamped), 0.3, 0.05, 4), {35.985, 73.394, 73.394, 108.22}, 3e-4);
}

TEST(Plate, OfAFreeSquareHasThreeRigidMotionsLess) {
  expect_ratios(square(Edges(4, held_free), 0.3, 0.07, 5), {13.468, 19.596, 24.270, 34.801, 34.801}, 3e-4);
}

/// Two sides are supported; Levy's solutions, nu = 0.3.
TEST(Plate, HasEdgesOfItsOwnOnEachSide) {
  expect_ratios(square({supported, clamped, supported, clamped}, 0.3, 0.07, 3), {28.951, 54.743, 69.327}, 3e-4);
  expect_ratios(square({supported, held_free, supported, held_free}, 0.3, 0.07, 4), {9.6314, 16.135, 36.726, 38.945},
                3e-4);
  expect_ratios(square({held_free, held_free, held_free, clamped}, 0.3, 0.07, 3), {3.4711, 8.5066, 21.285}, 3e-4);
}

/// One supported side lets it turn about that side; the plate is turned by 30 degrees.
TEST(Plate, TurnsAboutTheOnlySideThatIsSupported) {
  const double c = std::sqrt(0.75), s = 0.5;
  const mesh::PlaneRegion turned = inside({{0, 0}, {c, s}, {c - s, s + c}, {-s, c}});
  const auto upright = square({supported, held_free, held_free, held_free}, 0.3, 0.1, 3);
  expect_ratios(parameters(turned, {{supported, held_free, held_free, held_free}}, 0.3, 0.1, 3), upright, 1e-3);
  EXPECT_NEAR(upright[0], 6.648, 0.01);
  expect_ratios(parameters(turned, {Edges(4, supported)}, 0.3, 0.1, 1), {2 * pi_of_plates * pi_of_plates}, 1e-3);
}

TEST(Plate, OfADisc) {
  expect_ratios(parameters(disc(1), {{clamped}}, 0.3, 0.1, 4), {10.21583, 21.26040, 21.26040, 34.87704}, 3e-4);
  expect_ratios(parameters(disc(1), {{held_free}}, 0.33, 0.1, 5), {5.26204, 5.26204, 9.0689, 12.24389, 12.24389}, 3e-4);
  expect_ratios(parameters(disc(1), {{supported}}, 0.3, 0.1, 4), {4.93515, 13.89817, 13.89817, 25.6133}, 3e-4);
}

/// Both rims are clamped; Leissa 1969, table 2.21.
TEST(Plate, OfARing) {
  mesh::PlaneRegion ring = disc(1);
  ring.holes = disc(0.5).contours();
  expect_ratios(parameters(ring, {{clamped}, {clamped}}, 0.3, 0.06, 5), {89.2508, 90.2303, 90.2303, 93.3212, 93.3212},
                5e-4);
}

TEST(Plate, UnderTension) {
  const double k2 = 2 * pi_of_plates * pi_of_plates;
  EXPECT_NEAR(parameters(rectangle(1, 1), {Edges(4, supported)}, 0.3, 0.1, 1, 100)[0], std::sqrt(k2 * k2 + 100 * k2),
              0.01);
}

}  // namespace
}  // namespace idiophone::eigenmodes
