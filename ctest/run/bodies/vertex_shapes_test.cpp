#include "vertex_shapes.hpp"

#include <gtest/gtest.h>

#include "ranks.hpp"

namespace idiophone::bodies {
namespace {

ON_RANKS(1);

// More components than fit into a block, and not whole blocks.
TEST(VertexShapes, DisplacementsAndVelocitiesAreProductsWithTheShapes) {
  constexpr Eigen::Index vertices = 131, modes = 7;
  const Eigen::MatrixXd shapes = Eigen::MatrixXd::Random(3 * vertices, modes);
  const Eigen::VectorXd places = Eigen::VectorXd::Random(modes), rates = Eigen::VectorXd::Random(modes);
  VertexShapes found(shapes);
  found.find(places, rates);
  const auto error = [](const VertexShapes::Field& field, const Eigen::VectorXd& product) {
    return (field.reshaped().cast<double>() - product).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(error(found.displacements(), shapes * places), 2e-6);
  EXPECT_LT(error(found.velocities(), shapes * rates), 2e-6);
}

TEST(VertexShapes, WithoutModesNothingVibrates) {
  VertexShapes found(Eigen::MatrixXd(3 * 50, 0));
  found.find(Eigen::VectorXd(0), Eigen::VectorXd(0));
  EXPECT_TRUE(found.displacements().isZero(0.0));
  EXPECT_EQ(found.velocities().cols(), 50);
}

}  // namespace
}  // namespace idiophone::bodies
