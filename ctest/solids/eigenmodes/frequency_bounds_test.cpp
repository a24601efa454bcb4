// Two-sided bounds of frequencies against solutions of higher order.

#include "idiophone/solids/eigenmodes/frequency_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "block_expansion.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

FrequencyBounds bounds_of(VibratingBody& body, int wanted) {
  const Modes modes = body.find({.count = modes_for_bounds(wanted), .mass = MassMatrix::consistent}, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(modes.modes, std::back_inserter(shapes), &Mode::shape);
  return frequency_bounds(body.scene, body.mesh, shapes, wanted);
}

/// Cents between the bounds.
std::vector<double> widths(const FrequencyBounds& bounds) {
  std::vector<double> result;
  std::ranges::transform(bounds.upper, bounds.lower, std::back_inserter(result),
                         [](double upper, double lower) { return 1200 * std::log2(upper / lower); });
  return result;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ssize(values) / 2);
  return values[values.size() / 2];
}

/// @param reference  Hz, ascending; each above the frequency of the solid by less than a few 1e-6 of it
/// @return how many of them lie between their bounds
int expect_inside(const FrequencyBounds& bounds, const std::vector<double>& reference) {
  int inside = 0;
  for (std::size_t mode = 0; mode < bounds.lower.size(); ++mode) {
    EXPECT_LE(bounds.lower[mode], reference[mode]) << "mode " << mode;
    EXPECT_GE(bounds.upper[mode], (1 - 1e-5) * reference[mode]) << "mode " << mode;
    inside += bounds.lower[mode] <= reference[mode] && bounds.upper[mode] >= (1 - 1e-5) * reference[mode] ? 1 : 0;
  }
  return inside;
}

std::vector<double> expansion_of_box(const VibratingBody& body, const Vector3& size, int degree) {
  std::vector<double> all = expansion(body.scene.materials[0], Eigen::Matrix3d::Identity(), size, degree);
  return {all.begin() + 6, all.end()};
}

/// How many boxes are drawn: many for the long verification.
unsigned number_of_boxes() {
  return support::long_verification() ? 10000 : 10;
}

const Vector3 brick(0.1, 0.08, 0.06);

ON_RANKS(1);

TEST(FrequencyBounds, EncloseTheFrequenciesOfRandomBoxes) {
  std::mt19937 generator(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::ldexp(double(generator()), -32);
  };
  std::vector<double> all;
  int inside = 0;
  for (unsigned number = 0; number < number_of_boxes(); ++number) {
    SCOPED_TRACE(fmt::format("box {}", number));
    const Vector3 size(0.1, between(0.04, 0.1), between(0.03, 0.1));
    VibratingBody box = block(element::hex(4, 4), size, {1, 1, 1});
    box.scene.materials[0].poisson = between(0.0, 0.4);
    const FrequencyBounds bounds = bounds_of(box, 4);
    inside += expect_inside(bounds, expansion_of_box(box, size, 8));
    std::ranges::copy(widths(bounds), std::back_inserter(all));
  }
  fmt::print("{} boxes: {} of {} frequencies inside, median width {:.2f} cents, widest {:.2f}\n", number_of_boxes(),
             inside, all.size(), median(all), std::ranges::max(all));
  EXPECT_LT(median(all), 30);
}

// Limits of refined meshes, Hz: verification/limits/free_bar_limits.yaml.
TEST(FrequencyBounds, OfABarAreNarrow) {
  const std::vector<double> limits = {574.403, 1573.218, 1671.320, 2936.485, 3055.588, 4353.259};
  VibratingBody bar = block(element::hex(6, 3), {0.3, 0.03, 0.01}, {4, 1, 1});
  const FrequencyBounds bounds = bounds_of(bar, 6);
  expect_inside(bounds, limits);
  EXPECT_LT(median(widths(bounds)), 0.05);
}

TEST(FrequencyBounds, EncloseThoseOfABrickWithDistortedCells) {
  VibratingBody body = block(element::hex(4, 4), brick, {2, 1, 1});
  for (Vector3& node : body.mesh.nodes) {
    const Vector3 at = node.cwiseQuotient(brick);
    const double bulge = at[0] * (1 - at[0]) * at[1] * (1 - at[1]) * (1 + at[2]);
    node += bulge * Vector3(0.04, -0.03, 0);
  }
  const FrequencyBounds bounds = bounds_of(body, 6);
  expect_inside(bounds, expansion_of_box(body, brick, 9));
  EXPECT_LT(median(widths(bounds)), 10);
}

// A face that slides in its plane is a plane of symmetry of a body twice as long.
TEST(FrequencyBounds, EncloseThoseOfABrickOnASlidingFace) {
  VibratingBody half = block(element::hex(5, 4), brick, {1, 1, 1});
  half.fix("x0", {true, false, false});
  const FrequencyBounds bounds = bounds_of(half, 4);
  const std::vector<double> whole = expansion_of_box(half, {2 * brick[0], brick[1], brick[2]}, 11);
  for (std::size_t mode = 0; mode < bounds.lower.size(); ++mode) {
    EXPECT_TRUE(std::ranges::any_of(whole,
                                    [&](double frequency) {
                                      return bounds.lower[mode] <= frequency &&
                                             (1 - 1e-5) * frequency <= bounds.upper[mode];
                                    }))
        << "mode " << mode;
  }
  EXPECT_LT(median(widths(bounds)), 10);
}

TEST(FrequencyBounds, OfAClampedBrickLieBelowThoseOfAFinerMesh) {
  VibratingBody body = block(element::hex(4, 4), brick, {1, 1, 1});
  VibratingBody finer = block(element::hex(6, 5), brick, {1, 1, 1});
  body.fix("x0");
  finer.fix("x0");
  const FrequencyBounds bounds = bounds_of(body, 4);
  const Modes modes = finer.find({.count = 4, .mass = MassMatrix::consistent}, MPI_COMM_SELF);
  for (std::size_t mode = 0; mode < 4; ++mode) {
    EXPECT_LT(bounds.lower[mode], modes.modes[mode].frequency);
    EXPECT_GT(bounds.upper[mode], modes.modes[mode].frequency);
  }
}

std::string refusal(VibratingBody body) {
  try {
    (void)bounds_of(body, 2);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(FrequencyBounds, AreRefusedWhereTheyCouldNotBeTrusted) {
  EXPECT_NE(refusal(block(element::tet10, brick, {1, 1, 1})).find("tetrahedra"), std::string::npos);
  EXPECT_NE(refusal(block(element::hex(2, 8), brick, {1, 1, 1})).find("order"), std::string::npos);
  VibratingBody curved = block(element::hex(2, 2), brick, {1, 1, 1});
  for (Vector3& node : curved.mesh.nodes) {
    node[2] += node[0] * node[0];
  }
  EXPECT_NE(refusal(curved).find("curved"), std::string::npos);
  VibratingBody at_a_line = block(element::hex(2, 2), brick, {1, 1, 1});
  at_a_line.mesh.groups["line"] = {0, 1, 2};
  at_a_line.fix("line");
  EXPECT_NE(refusal(at_a_line).find("points or lines"), std::string::npos);
  VibratingBody layered = block(element::hex(2, 2), brick, {1, 1, 1});
  layered.scene.bodies[0].regions.resize(2);
  EXPECT_NE(refusal(layered).find("several materials"), std::string::npos);
  VibratingBody taut = block(element::hex(2, 2), brick, {1, 1, 1});
  taut.scene.bodies[0].prestress.emplace();
  EXPECT_NE(refusal(taut).find("tension"), std::string::npos);
}

}  // namespace
}  // namespace idiophone::eigenmodes
