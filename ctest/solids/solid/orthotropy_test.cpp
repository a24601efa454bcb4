// A material with three axes answers a pull or a shear along each by the constants given for it, however the axes lie
// in the body; waves run through it at the speeds that Christoffel's equation gives.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <complex>
#include <numbers>

#include "idiophone/solids/solid/tangent_stiffness.hpp"
#include "strained_block.hpp"

namespace idiophone::solid {
namespace {

/// Steel as if it were orthotropic.
scene::Material disguised_steel() {
  scene::Material material{"steel", 2e11, 0.3, 7850, {0, 1e-6}, {}};
  material.orthotropy = {Vector3::Constant(2e11), Vector3::Constant(0.3), Vector3::Constant(2e11 / 2.6)};
  return material;
}

class OrthotropyTest : public ::testing::TestWithParam<element::Type>, public StrainedBlock {
 protected:
  OrthotropyTest() : StrainedBlock(GetParam()) {}
};

TEST_P(OrthotropyTest, PullAlongEachAxisMeetsItsYoungsModulus) {
  const auto [young, poisson, shear] = *spruce().orthotropy;
  Matrix3d shrinking = Matrix3d::Zero();  // nu_ij
  shrinking << -1, poisson[0], poisson[2], poisson[0] * young[1] / young[0], -1, poisson[1],
      poisson[2] * young[2] / young[0], poisson[1] * young[2] / young[1], -1;
  for (const Matrix3d& axes : {Matrix3d(Matrix3d::Identity()), some_turn()}) {
    const Solid body = solid(spruce(), axes);
    for (int axis = 0; axis < 3; ++axis) {
      const Matrix3d own = (-strain * shrinking.row(axis)).asDiagonal();
      move(axes * own * axes.transpose());
      const Matrix3d found = axes.transpose() * stress(body) * axes;
      Matrix3d expected = Matrix3d::Zero();
      expected(axis, axis) = young[axis] * strain;
      EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm()) << "axis " << axis;
      EXPECT_NEAR(energy(body) / (0.5 * young[axis] * strain * strain * volume), 1.0, 1e-5) << "axis " << axis;
    }
  }
}

TEST_P(OrthotropyTest, ShearOfEachPairOfAxesMeetsItsShearModulus) {
  constexpr int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  for (const Matrix3d& axes : {Matrix3d(Matrix3d::Identity()), some_turn()}) {
    const Solid body = solid(spruce(), axes);
    for (int p = 0; p < 3; ++p) {
      const auto [i, j] = pairs[p];
      Matrix3d own = Matrix3d::Zero();
      own(i, j) = own(j, i) = strain / 2;
      move(axes * own * axes.transpose());
      const Matrix3d found = axes.transpose() * stress(body) * axes;
      const Matrix3d expected = 2 * spruce().orthotropy->shear[p] * own;
      EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm()) << "pair " << p;
    }
  }
}

TEST_P(OrthotropyTest, OfEqualConstantsIsIsotropyHoweverItLies) {
  const Solid disguised = solid(disguised_steel(), some_turn());
  scene::Material plain = disguised_steel();
  plain.orthotropy.reset();
  const Solid isotropic = solid(plain, Matrix3d::Identity());
  Matrix3d gradient;
  gradient << 0.01, 0.02, -0.03, 0.04, -0.05, 0.06, 0.01, -0.02, 0.03;
  move(gradient, 1e4 * gradient.transpose());
  EXPECT_LT((stress(disguised) - stress(isotropic)).norm(), 1e-12 * stress(isotropic).norm());
  EXPECT_NEAR(energy(disguised) / energy(isotropic), 1.0, 1e-12);
}

TEST_P(OrthotropyTest, TangentIsTheDerivativeOfTheForce) {
  std::vector<Vector3> reference;
  std::vector<Vector3> displacement;
  for (const Index node : mesh.element_nodes(0)) {
    reference.push_back(mesh.nodes[node]);
    displacement.emplace_back(0.02 * Vector3(std::sin(node), std::cos(3 * node), std::sin(2 * node)));
  }
  mesh::BodyPart one = part.bodies[0];
  one.element_ids.resize(1);
  one.elements.resize(reference.size());
  scene::Material lossless = spruce();
  lossless.damping = {};
  const Solid element(one, part.reference, lossless, some_turn());
  const auto forces = [&](const std::vector<Vector3>& u) {
    for (std::size_t a = 0; a < u.size(); ++a) {
      Eigen::Map<Vector3>(state[one.elements[a]].displacement) = u[a];
    }
    std::vector<NodeForce> all(state.size());
    element.add_internal_force(state, all);
    Eigen::VectorXd found(3 * std::ssize(u));
    for (std::size_t a = 0; a < u.size(); ++a) {
      found.segment<3>(static_cast<Eigen::Index>(3 * a)) = Eigen::Map<const Vector3>(all[one.elements[a]].component);
    }
    return found;
  };
  const Eigen::MatrixXd tangent = tangent_stiffness(mesh.element, element.elasticity(), reference, displacement);
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-12 * tangent.norm());
  constexpr double delta = 1e-6;
  for (Eigen::Index column = 0; column < tangent.cols(); ++column) {
    std::vector<Vector3> more = displacement;
    std::vector<Vector3> less = displacement;
    more[static_cast<std::size_t>(column) / 3][column % 3] += delta;
    less[static_cast<std::size_t>(column) / 3][column % 3] -= delta;
    const Eigen::VectorXd derivative = (forces(less) - forces(more)) / (2 * delta);
    EXPECT_LT((tangent.col(column) - derivative).norm(), 1e-6 * tangent.norm()) << "component " << column;
  }
}

// The loss factor is in units of the elasticity, whatever that is.
TEST_P(OrthotropyTest, HasALossFactorToo) {
  scene::Material lossy = spruce();
  lossy.damping.loss = {0.05, {100, 10000}, {}, {}};
  const Relaxation relaxation = fit_relaxation(*lossy.damping.loss);
  constexpr double frequency = 1000;
  constexpr int steps = 200;  // a period
  constexpr double dt = 1 / (frequency * steps);
  const double w = 2 * std::numbers::pi * frequency;
  Solid body = solid(lossy, some_turn());
  body.begin_memory(dt);
  const double static_stress = [&] {
    move(strain * Matrix3d::Ones());
    return stress(solid(spruce(), some_turn()))(0, 1);
  }();
  std::complex<double> sum = 0.0;
  std::vector<NodeForce> forces(state.size());
  for (int n = 0; n < 20 * steps; ++n) {
    const double before = std::sin(w * (n - 1) * dt);
    const double now = std::sin(w * n * dt);
    move(strain * now * Matrix3d::Ones(), strain * (now - before) / dt * Matrix3d::Ones());
    if (n >= 19 * steps) {
      sum += stress(body)(0, 1) * std::exp(std::complex<double>(0, -w * n * dt));
    }
    body.add_internal_force_and_remember(state, forces);
  }
  const std::complex<double> found = sum * std::complex<double>(0, 2.0 / steps) / static_stress;
  const std::complex<double> expected = relaxation.modulus(w) + std::complex<double>(0, w * 1e-6);
  EXPECT_NEAR(found.real() / expected.real(), 1.0, 2e-3);
  EXPECT_NEAR(found.imag() / expected.imag(), 1.0, 2e-2);
}

INSTANTIATE_TEST_SUITE_P(Types, OrthotropyTest, ::testing::Values(element::tet4, element::tet10, element::hex(3, 2)),
                         [](const auto& test) { return std::string(element::name(test.param)); });

// Speeds v of plane waves along an axis: rho v^2 is an eigenvalue of C_ijkl n_j n_l: one is C_ii, two are shear moduli.
TEST(Orthotropy, WavesAlongAnAxisHaveItsModuli) {
  const Matrix3d axes = some_turn();
  const StiffnessMatrix turned = stiffness_matrix(elasticity(spruce(), axes));
  const StiffnessMatrix own = stiffness_matrix(elasticity(spruce()));
  EXPECT_EQ(Eigen::LLT<StiffnessMatrix>(turned).info(), Eigen::Success);
  const auto full = [&](int i, int j) { return i == j ? i : 6 - i - j; };
  const Vector3 shear = spruce().orthotropy->shear;
  const Matrix3d moduli =
      (Matrix3d() << own(0, 0), shear[0], shear[2], shear[0], own(1, 1), shear[1], shear[2], shear[1], own(2, 2))
          .finished();
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 n = axes.col(axis);
    Matrix3d christoffel = Matrix3d::Zero();
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 3; ++j) {
          for (int l = 0; l < 3; ++l) {
            christoffel(i, k) += turned(full(i, j), full(k, l)) * n[j] * n[l];
          }
        }
      }
    }
    const Matrix3d found = axes.transpose() * christoffel * axes;
    const Matrix3d expected = moduli.row(axis).asDiagonal();
    EXPECT_LT((found - expected).norm(), 1e-12 * found.norm()) << "axis " << axis;
  }
}

}  // namespace
}  // namespace idiophone::solid
