// Wind on blocks against the formula of its pressure, and on a free body against the exact motion.

#include "idiophone/solids/motion/wind.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "idiophone/foundation/deck/values.hpp"
#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {

ON_RANKS(1);

namespace {

constexpr double air_density = 1.21, drag = 1.5;  // kg/m3
const Vector3 block_size(0.3, 0.2, 0.1);          // m
const Vector3 face_areas(0.2 * 0.1, 0.3 * 0.1, 0.3 * 0.2);

scene::Wind wind_of(const Vector3& velocity) {
  scene::Wind wind;
  wind.velocity = velocity;
  wind.drag = drag;
  wind.signal = {.shape = scene::Signal::Shape::constant, .duration = deck::infinity, .table = {}};
  return wind;
}

Laboratory block_in(const scene::Wind& wind) {
  Laboratory lab(support::block_mesh(element::tet4, block_size, {3, 2, 1}));
  lab.scene.radiation.air.density = air_density;
  lab.scene.winds.push_back(wind);
  lab.attachments.winds.push_back(lab.mesh.surface);
  return lab;
}

Vector3 total(const Laboratory& lab, double time = 0.0) {
  const auto sums = lab.motion->dynamics().loads().winds().front().total(time, lab.motion->state());
  return {sums[0].value(), sums[1].value(), sums[2].value()};
}

/// On a box: each face that the relative velocity blows at.
Vector3 expected(const Vector3& relative) {
  return 0.5 * air_density * drag * relative.norm() * relative.cwiseProduct(face_areas);
}

void expect_near(const Vector3& found, const Vector3& wanted) {
  EXPECT_LT((found - wanted).norm(), 1e-9 * (1e-9 + wanted.norm())) << found.transpose() << " " << wanted.transpose();
}

}  // namespace

TEST(Wind, PushesTheFacesThatItBlowsAt) {
  for (const Vector3& velocity : {Vector3(10, 0, 0), Vector3(0, -7, 0), Vector3(3, -4, 12)}) {
    Laboratory lab = block_in(wind_of(velocity));
    lab.begin(1e-5);
    expect_near(total(lab), expected(velocity));
  }
}

TEST(Wind, PushesByItsVelocityRelativeToTheBody) {
  const Vector3 velocity(10, 2, 0);
  for (const Vector3& own : {Vector3(4, 0, 0), Vector3(10, 2, 0), Vector3(12, 2, 1)}) {
    Laboratory lab = block_in(wind_of(velocity));
    lab.scene.bodies[0].velocity = own;
    lab.begin(1e-5);
    expect_near(total(lab), expected(velocity - own));
  }
}

TEST(Wind, IsAtRestWithoutItsSignal) {
  scene::Wind wind = wind_of({10, 0, 0});
  wind.signal.start = 2.0;
  Laboratory lab = block_in(wind);
  lab.begin(1e-5);
  EXPECT_EQ(total(lab, 1.9), Vector3(Vector3::Zero()));
  expect_near(total(lab, 2.1), expected({10, 0, 0}));
}

/// Along an axis, m dv/dt = k (w - v)^2 with k = 1/2 density drag A, so that v = w - w/(1 + k w t/m).
TEST(Wind, CarriesAFreeBodyAlongAndItsWorkIsInTheLedger) {
  constexpr double speed = 5.0, step = 5e-5, density = 0.5;
  constexpr int steps = 2000;
  Laboratory lab = block_in(wind_of({speed, 0, 0}));
  lab.scene.materials[0].young = 3e4;
  lab.scene.materials[0].density = density;
  lab.begin(step);
  lab.advance(steps);
  const double mass = density * block_size.prod();
  const double rate = 0.5 * air_density * drag * face_areas[0] * speed / mass;  // 1/s
  const BodyMotion seen = lab.observe();
  const double wanted = speed - speed / (1.0 + rate * step * steps);
  EXPECT_GT(wanted, 0.5 * speed);
  EXPECT_NEAR(seen.velocity.x() / wanted, 1.0, 2e-3);
  EXPECT_NEAR(lab.motion->work().value() / (0.5 * mass * wanted * wanted), 1.0, 4e-3);
}

TEST(Wind, LetsASavedStateGoOn) {
  scene::Wind wind = wind_of({30, 5, -3});
  wind.gusts = {.intensity = 0.3, .time = 0.001, .seed = 7};
  Laboratory lab = block_in(wind);
  expect_a_saved_state_to_go_on(lab, 1e-5, 100);
}

TEST(Gusts, HaveTheirIntensityAndTheirCorrelation) {
  scene::Wind wind = wind_of({8, 6, 0});
  wind.gusts = {.intensity = 0.2, .time = 0.5, .seed = 3};
  const WindVelocity velocity(wind);
  Vector3 mean = Vector3::Zero(), square = Vector3::Zero(), product = Vector3::Zero();
  constexpr int count = 40000;
  for (int n = 0; n < count; ++n) {
    const double time = 0.25 * n;
    const Vector3 now = velocity.at(time) - wind.velocity, later = velocity.at(time + 0.5) - wind.velocity;
    mean += now / count;
    square += now.cwiseAbs2() / count;
    product += now.cwiseProduct(later) / count;
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(mean[i], 0.0, 0.02) << i;
    EXPECT_NEAR(std::sqrt(square[i]), 0.2 * 10.0, 0.02) << i;
    EXPECT_NEAR(product[i] / square[i], std::exp(-1.0), 0.03) << i;
  }
}

TEST(Gusts, AreThoseOfTheirSeed) {
  scene::Wind wind = wind_of({1, 0, 0});
  wind.gusts = {.intensity = 0.5, .time = 1.0, .seed = 3};
  const Vector3 first = WindVelocity(wind).at(1.7);
  EXPECT_EQ(WindVelocity(wind).at(1.7), first);
  wind.gusts.seed = 4;
  EXPECT_GT((WindVelocity(wind).at(1.7) - first).norm(), 0.01);
}

}  // namespace idiophone::motion
