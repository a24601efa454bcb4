// Gauges, where the deformation is known: arcs, and a bar in pure bending.

#include "idiophone/run/bodies/gauge_channels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "ranks.hpp"
#include "stages.hpp"

namespace idiophone::bodies {
namespace {

using Quantity = scene::Gauge::Quantity;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double radius = 0.2, thickness = 0.01, length = 0.1;  // m; the radius is that of the middle plane

/// A bar along x in pure bending about y: its middle plane becomes an arc, whose centre is above.
Vector3 bent(const Vector3& place) {
  const double angle = place.x() / radius, r = radius - place.z();
  return {r * std::sin(angle), place.y(), radius - r * std::cos(angle)};
}

/// The channels of gauges on a bar that begins bent.
std::map<std::string, std::vector<double>> gauges_of_bent_bar(MPI_Comm communicator) {
  const std::vector<std::string> overrides = {
      "bodies={bar: {mesh: ../../../meshes/bar.geo, parameters: {length: 0.1, width: 0.05, thickness: 0.01, size: "
      "0.05}, element: tet4, material: rubber}}",
      "gauges={above: {type: strain, points: [{at: [0, -0.025, 0.005]}, {at: [0.1, -0.025, 0.005]}]},"
      "below: {type: strain, points: [{at: [0, -0.025, -0.005]}, {at: [0.1, -0.025, -0.005]}]},"
      "chord: {type: distance, points: [{at: [0, -0.025, 0.005]}, {at: [0.1, -0.025, 0.005]}]},"
      "knee: {type: angle, points: [{at: [0, -0.025, 0.005]}, {at: [0.05, -0.025, 0.005]}, {at: [0.1, -0.025, "
      "0.005]}]},"
      "bow: {type: curvature, points: [{at: [0, -0.025, 0.005]}, {at: [0.05, -0.025, 0.005]}, {at: [0.1, -0.025, "
      "0.005]}]}}"};
  Preparation ready =
      prepare(read_deck(IDIOPHONE_SOURCE_DIR "/ctest/app/decks/free.yaml", overrides, communicator), communicator);
  auto& displacement = ready.initial_state.displacement;
  displacement.assign(std::size_t{3} * ready.part.global_nodes, 0.0);
  for (std::size_t node = 0; node < ready.part.node_ids.size(); ++node) {
    const Vector3 moved = bent(ready.part.reference[node]) - ready.part.reference[node];
    std::ranges::copy(moved, &displacement[std::size_t{3} * ready.part.node_ids[node]]);
  }
  FiniteElementSource source(ready, support::stages(), communicator);
  Channels channels(source.channels());
  std::map<std::string, std::vector<double>> rows;
  channels.subscribe([&](const spectra::Series& channel, std::span<const double> values) {
    auto& all = rows[channel.path];
    all.insert(all.end(), values.begin(), values.end());
  });
  surface::SurfaceMotion motion;
  source.start(motion);
  channels.deliver();
  for (int sample = 1; sample <= 4; ++sample) {
    source.advance(motion);
  }
  channels.deliver();
  return rows;
}

}  // namespace

ON_RANKS(1);

TEST(Gauges, GiveTheCurvatureOfAnArcInAnyPlane) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3 centre(3, -2, 1);
  std::vector<Vector3> points;
  for (const double angle : {0.3, 0.5, 1.2}) {
    points.emplace_back(centre + turn * Vector3(radius * std::cos(angle), radius * std::sin(angle), 0));
  }
  const std::vector<double> found = measured(Quantity::curvature, points, points);
  const Vector3 expected = (centre - points[1]) / (radius * radius);
  EXPECT_LT((Vector3(found[0], found[1], found[2]) - expected).norm(), 1e-10 / radius);
  EXPECT_NEAR(measured(Quantity::angle, points, points)[0], std::numbers::pi - 0.5 * 0.9, 1e-12);
}

TEST(Gauges, HaveNoCurvatureOnALineAndWherePointsMeet) {
  const std::vector<Vector3> line = {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}, meeting(3, Vector3(1, 1, 1));
  EXPECT_THAT(measured(Quantity::curvature, line, line), ElementsAre(0.0, 0.0, 0.0));
  EXPECT_THAT(measured(Quantity::curvature, meeting, line), ElementsAre(0.0, 0.0, 0.0));
  EXPECT_NEAR(measured(Quantity::angle, line, line)[0], std::numbers::pi, 1e-12);
  EXPECT_EQ(measured(Quantity::angle, meeting, line)[0], 0.0);
}

ON_RANKS(1, 3);

TEST(GaugeChannels, AreExactInPureBending) {
  const auto rows = gauges_of_bent_bar(MPI_COMM_WORLD);
  if (support::rank() != 0) {
    EXPECT_THAT(rows.at("/gauges/bow/curvature"), IsEmpty());
    return;
  }
  const double half = 0.5 * length / radius, above = radius - thickness / 2, below = radius + thickness / 2;
  EXPECT_NEAR(rows.at("/gauges/above/strain")[0], 2 * above * std::sin(half) / length - 1, 1e-12);
  EXPECT_NEAR(rows.at("/gauges/below/strain")[0], 2 * below * std::sin(half) / length - 1, 1e-12);
  EXPECT_NEAR(rows.at("/gauges/chord/distance")[0], 2 * above * std::sin(half), 1e-12);
  EXPECT_NEAR(rows.at("/gauges/knee/angle")[0], std::numbers::pi - half, 1e-11);
  const auto& curvature = rows.at("/gauges/bow/curvature");
  EXPECT_THAT(std::vector(curvature.begin(), curvature.begin() + 3),
              ElementsAre(DoubleNear(-std::sin(half) / above, 1e-10), DoubleNear(0.0, 1e-10),
                          DoubleNear(std::cos(half) / above, 1e-10)));
  EXPECT_EQ(curvature.size(), 3U * 5);  // rows of the start and of four samples
  EXPECT_NE(curvature[0], curvature[12]);
}

TEST(GaugeChannels, HaveTheSameBitsOnAnyNumberOfRanks) {
  const auto together = gauges_of_bent_bar(MPI_COMM_WORLD), alone = gauges_of_bent_bar(MPI_COMM_SELF);
  if (support::rank() == 0) {
    EXPECT_EQ(together, alone);
  }
}

}  // namespace idiophone::bodies
