// Loss factors by direction: each modulus of wood has its own, however the wood lies in the body.

#include "idiophone/solids/solid/directional_loss.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <complex>
#include <numbers>

#include "strained_block.hpp"

namespace idiophone::solid {
namespace {

using Complex6 = Eigen::Matrix<std::complex<double>, 6, 6>;

const scene::DirectionalLoss measured_losses = {{0.005, 0.02, 0.03}, {0.016, 0.04, 0.01}};
constexpr double largest_loss = 0.04;

scene::Material lossy_spruce(const scene::DirectionalLoss& directions = measured_losses) {
  scene::Material material = spruce();
  material.damping.loss = {largest_loss, {100, 10000}, {}, {}, {}, directions};
  return material;
}

/// C + (M - 1) C_r
Complex6 complex_stiffness(const OrientedMaterial& oriented, std::complex<double> modulus) {
  return stiffness_matrix(elasticity(oriented.material, oriented.axes)).cast<std::complex<double>>() +
         (modulus - 1.0) * stiffness_matrix(relaxing_elasticity(oriented)).cast<std::complex<double>>();
}

TEST(DirectionalLoss, EachModulusHasItsOwnLossFactor) {
  const OrientedMaterial oriented{lossy_spruce()};
  const Complex6 compliance = complex_stiffness(oriented, {1.0, largest_loss}).inverse();
  const std::array<double, 6> expected = {0.005, 0.02, 0.03, 0.04, 0.01, 0.016};
  for (int i = 0; i < 6; ++i) {
    const std::complex<double> modulus = 1.0 / compliance(i, i);
    EXPECT_NEAR(modulus.imag() / modulus.real() / expected.at(i), 1.0, 2e-3) << i;
  }
}

TEST(DirectionalLoss, LossesThatLeaveNoStiffnessAtRestAreRefused) {
  const OrientedMaterial oriented{lossy_spruce({{0.3, 0.0, 0.0}, {0.0, 0.0, 0.0}})};
  EXPECT_THROW((void)elasticity_at(oriented, 1 - 1 / largest_relaxing_share(oriented) - 1e-6), deck::DeckError);
  EXPECT_NO_THROW((void)elasticity_at(oriented, 1 - 1 / largest_relaxing_share(oriented) + 1e-6));
}

class DirectionalLossTest : public ::testing::TestWithParam<element::Type>, public StrainedBlock {
 protected:
  DirectionalLossTest() : StrainedBlock(GetParam()), forces(state.size()) {}

  void remember(Solid& body) { body.add_internal_force_and_remember(state, forces); }

  std::vector<NodeForce> forces;
};

TEST_P(DirectionalLossTest, TheSameInAllDirectionsIsALossFactor) {
  scene::Material plain = spruce();
  plain.damping.loss = {largest_loss, {100, 10000}, {}, {}};
  const Vector3 all = Vector3::Constant(largest_loss);
  Solid by_direction = solid(lossy_spruce({all, all}), some_turn());
  Solid by_one = solid(plain, some_turn());
  constexpr double dt = 1e-5;
  by_direction.begin_memory(dt);
  by_one.begin_memory(dt);
  for (int n = 1; n < 20; ++n) {
    move(strain * n * Matrix3d::Ones(), strain / dt * Matrix3d::Ones());
    EXPECT_LT((stress(by_direction) - stress(by_one)).norm(), 1e-12 * stress(by_one).norm());
    EXPECT_NEAR(energy(by_direction) / energy(by_one), 1.0, 1e-12);
    remember(by_direction);
    remember(by_one);
  }
  EXPECT_NEAR(by_direction.damping(1e5) / by_one.damping(1e5), 1.0, 0.1);
}

TEST_P(DirectionalLossTest, AnOscillationMeetsTheComplexStiffness) {
  const OrientedMaterial oriented{lossy_spruce(), some_turn()};
  const Relaxation relaxation = fit_relaxation(*oriented.material.damping.loss);
  constexpr double frequency = 1000;
  constexpr int steps = 200;  // a period
  constexpr double dt = 1 / (frequency * steps);
  const double w = 2 * std::numbers::pi * frequency;
  Solid body = solid(oriented.material, oriented.axes);
  body.begin_memory(dt);
  Matrix3d shape;
  shape << 1.0, 0.3, -0.2, 0.3, -0.5, 0.4, -0.2, 0.4, 0.8;
  Eigen::Matrix3cd found = Eigen::Matrix3cd::Zero();
  for (int n = 0; n < 20 * steps; ++n) {
    const double before = std::sin(w * (n - 1) * dt);
    const double now = std::sin(w * n * dt);
    move(strain * now * shape, strain * (now - before) / dt * shape);
    if (n >= 19 * steps) {
      found += stress(body) * std::exp(std::complex<double>(0, -w * n * dt));
    }
    remember(body);
  }
  found *= std::complex<double>(0, 2.0 / steps);
  const double beta = oriented.material.damping.stiffness;
  const Complex6 stiffness =
      complex_stiffness(oriented, relaxation.modulus(w)) +
      std::complex<double>(0, w * beta) * stiffness_matrix(body.elasticity()).cast<std::complex<double>>();
  Eigen::Vector<std::complex<double>, 6> e;
  for (int p = 0; p < 6; ++p) {
    e[p] = (p < 3 ? 1.0 : 2.0) * strain * shape(direction_pairs[p][0], direction_pairs[p][1]);
  }
  const Eigen::Vector<std::complex<double>, 6> expected = stiffness * e;
  for (int p = 0; p < 6; ++p) {
    const std::complex<double> s = found(direction_pairs[p][0], direction_pairs[p][1]);
    EXPECT_LT(std::abs(s.real() - expected[p].real()), 1e-4 * expected.norm()) << p;
    EXPECT_LT(std::abs(s.imag() - expected[p].imag()), 1e-2 * expected.imag().norm()) << p;
  }
}

TEST_P(DirectionalLossTest, ABlockThatIsHeldLosesTheEnergyOfItsOverstrains) {
  Solid body = solid(lossy_spruce(), some_turn());
  constexpr double dt = 1e-5;
  body.begin_memory(dt);
  Matrix3d shape;
  shape << 1.0, 0.3, -0.2, 0.3, -0.5, 0.4, -0.2, 0.4, 0.8;
  move(strain * shape, strain / dt * shape);
  const Solid elastic = solid(spruce(), some_turn());
  double before = energy(body);
  EXPECT_GT(before, energy(elastic));
  remember(body);
  for (int n = 0; n < 1000; ++n) {
    move(strain * shape);
    const double now = energy(body);
    ASSERT_LE(now, before);
    before = now;
    remember(body);
  }
  const Solid rested = solid(lossy_spruce(), some_turn());  // for ever
  EXPECT_NEAR(before / energy(rested), 1.0, 1e-2);
  EXPECT_LT(before, energy(elastic));
}

INSTANTIATE_TEST_SUITE_P(Types, DirectionalLossTest, ::testing::Values(element::tet4, element::hex(3, 2)),
                         [](const auto& test) { return std::string(element::name(test.param)); });

}  // namespace
}  // namespace idiophone::solid
