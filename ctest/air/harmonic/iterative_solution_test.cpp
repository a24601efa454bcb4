// The iterative solver of boundary elements against LU factors of the full matrix.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "long_verification.hpp"
#include "vibrating_solid.hpp"
#include "with_petsc.hpp"

namespace idiophone::harmonic {
namespace {

using namespace radiation;  // the vibrating solids

using IterativeSolution = WithPetsc;

/// A motion of the corners without any symmetry, and rigid motion along x.
std::vector<std::vector<Complex>> motions(const Boundary& boundary) {
  std::vector<std::vector<Complex>> all(2);
  for (const auto& [a, b, c] : boundary.triangles) {
    const Vector3 first = boundary.vertices[a];
    const Vector3 normal = (boundary.vertices[b] - first).cross(boundary.vertices[c] - first).normalized();
    for (const Index vertex : {a, b, c}) {
      const Vector3& place = boundary.vertices[vertex];
      all[0].push_back(normal.dot(Vector3(10.0 * place[1], 1.0, std::sin(20.0 * place[0]))));
      all[1].push_back(normal[0]);
    }
  }
  return all;
}

/// Largest differences of the powers, dB, and of the pressure over its largest value.
struct Difference {
  double power = 0.0, pressure = 0.0;
};

Difference difference(const Boundary& boundary, double wave_number, std::span<const PointSource> sources = {}) {
  const BoundaryElements elements(boundary, quiet_air);
  const auto both = motions(boundary);
  const auto direct = elements.solve(wave_number, both, sources, LinearSolver::direct);
  const auto iterative = elements.solve(wave_number, both, sources, LinearSolver::iterative);
  Difference worst;
  for (std::size_t m = 0; m < both.size(); ++m) {
    double largest = 0.0, farthest = 0.0;
    for (std::size_t v = 0; v < boundary.vertices.size(); ++v) {
      largest = std::max(largest, std::abs(direct[m].pressure[v]));
      farthest = std::max(farthest, std::abs(iterative[m].pressure[v] - direct[m].pressure[v]));
    }
    worst.pressure = std::max(worst.pressure, farthest / largest);
    worst.power = std::max(worst.power, std::abs(10.0 * std::log10(iterative[m].power / direct[m].power)));
  }
  return worst;
}

void expect_agreement(const Difference& found) {
  EXPECT_LT(found.power, 0.02);
  EXPECT_LT(found.pressure, 0.01);
}

TEST_F(IterativeSolution, AgreesWithTheDirectOneOnASphere) {
  const Solid solid = icosphere(0.1, 8);
  const std::vector<double> daily{3.0}, all{0.1, 3.0, 10.0};
  for (const double ka : support::long_verification() ? all : daily) {
    SCOPED_TRACE(ka);
    expect_agreement(difference({solid.vertices, solid.triangles}, ka / 0.1));
  }
}

TEST_F(IterativeSolution, AgreesWithTheDirectOneOnAThinPlate) {
  const Solid solid = box({0.3, 0.2, 0.006}, {15, 10, 1});
  for (const double frequency : {200.0, 2000.0}) {
    SCOPED_TRACE(frequency);
    expect_agreement(
        difference({solid.vertices, solid.triangles}, 2.0 * std::numbers::pi * frequency / quiet_air.speed));
  }
}

TEST_F(IterativeSolution, AgreesWithTheDirectOneAboveAFloorBesideASource) {
  Solid solid = box({0.1, 0.1, 0.1}, {6, 6, 6});
  for (Vector3& vertex : solid.vertices) {
    vertex[2] += 0.06;
  }
  const radiation::ReflectingPlane floor{.at = {0, 0, 0}, .normal = {0, 0, 1}, .reflection = 0.8};
  const PointSource source{.position = {0.3, 0.1, 0.4}, .strength = 2.0};
  expect_agreement(difference({solid.vertices, solid.triangles, floor}, 30.0, std::span(&source, 1)));
}

TEST_F(IterativeSolution, SaysIfItDoesNotConverge) {
  const Solid solid = icosphere(0.1, 3);
  const BoundaryElements elements({solid.vertices, solid.triangles}, quiet_air);
  PetscOptionsSetValue(nullptr, "-radiation_ksp_max_it", "1");
  EXPECT_THAT([&] { (void)elements.solve(20.0, motions(elements.boundary()), {}, LinearSolver::iterative); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("did not converge")));
  PetscOptionsClearValue(nullptr, "-radiation_ksp_max_it");
}

}  // namespace
}  // namespace idiophone::harmonic
