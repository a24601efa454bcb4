// Membranes whose eigenvalues are known.

#include "idiophone/solids/eigenmodes/membrane.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr double pi = std::numbers::pi;

/// Eigenvalues of -laplacian: (2 pi f)^2 with unit tension and density, 1/m2.
std::vector<double> eigenvalues(const mesh::PlaneRegion& region, double size, int count) {
  std::vector<double> values;
  for (const MembraneMode& mode : membrane_modes(mesh::mesh_region(region, size), {1, 1}, count, {})) {
    values.push_back(std::pow(2 * pi * mode.frequency, 2));
  }
  return values;
}

ON_RANKS(1);

TEST(Membrane, OfASquare) {
  const auto found = eigenvalues({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 0}, 0.05, 6);  // clockwise
  const std::vector<double> exact = {2, 5, 5, 8, 10, 10};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(found[i] / (pi * pi * exact[i]), 1, 5e-5) << i;
  }
  const auto finer = eigenvalues({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0}, 0.02, 3);
  EXPECT_NEAR(finer[0] / (2 * pi * pi), 1, 1e-6);
  EXPECT_NEAR(finer[2] / (5 * pi * pi), 1, 1e-6);
}

TEST(Membrane, OfADisc) {
  const auto found = eigenvalues({{}, 2.0}, 0.06, 6);
  const std::vector<double> roots = {2.404825557695773, 3.831705970207512, 3.831705970207512,
                                     5.135622301840683, 5.135622301840683, 5.520078110286311};
  for (std::size_t i = 0; i < roots.size(); ++i) {
    EXPECT_NEAR(found[i] / std::pow(roots[i] / 2, 2), 1, i < 3 ? 1e-6 : 3e-6) << i;
  }
}

/// Three unit squares: Fox, Henrici and Moler 1967; the third mode has no singularity.
TEST(Membrane, OfThreeSquaresAroundACorner) {
  const auto found = eigenvalues({{{0, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, -1}, {0, -1}}, 0}, 0.03, 3);
  EXPECT_NEAR(found[0] / 9.6397238440219, 1, 1e-6);
  EXPECT_NEAR(found[1] / 15.197251926454343, 1, 1e-6);
  EXPECT_NEAR(found[2] / (2 * pi * pi), 1, 1e-6);
}

TEST(Membrane, HasUnitModalMassAndItsTension) {
  const mesh::PlaneMesh mesh = mesh::mesh_region({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0}, 0.1);
  const auto modes = membrane_modes(mesh, {.tension = 50, .density = 0.5}, 0, 12.0);
  ASSERT_EQ(modes.size(), 3) << "7.07 Hz and twice 11.2 Hz";
  EXPECT_NEAR(modes[0].frequency, std::sqrt(50 / 0.5 * 2) / 2, 1e-3);
  EXPECT_NEAR(*std::ranges::max_element(modes[0].shape), 2 / std::sqrt(0.5), 0.01);
  for (const Index node : mesh.rim) {
    EXPECT_EQ(modes[0].shape[node], 0);
  }
}

TEST(Membrane, IsRefusedIfItsOutlineCrossesItselfOrItHasNoModes) {
  EXPECT_ANY_THROW((void)mesh::mesh_region({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 0}, 0.1));
  const mesh::PlaneMesh mesh = mesh::mesh_region({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0}, 0.3);
  EXPECT_ANY_THROW((void)membrane_modes(mesh, {1, 1}, 0, 0.5));
  EXPECT_ANY_THROW((void)membrane_modes(mesh, {1, 1}, 100000, {}));
}

}  // namespace
}  // namespace idiophone::eigenmodes
