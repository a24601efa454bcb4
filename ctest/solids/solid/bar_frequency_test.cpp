// The first longitudinal frequency of a clamped bar without lateral contraction is c/(4 L), c^2 = E/rho, exactly.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <numbers>

#include "block_mesh.hpp"
#include "idiophone/solids/solid/solid.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"

namespace idiophone::solid {
namespace {

/// Relative error of the first frequency with lumped mass, sides held so that the bar only moves along x.
double frequency_error(element::Type type, int cells) {
  const scene::Material material{"corkish", 1.0, 0.0, 1.0, {}, {}};
  const mesh::Mesh mesh = support::block_mesh(type, {1.0, 0.2, 0.2}, {5 * cells, cells, cells});
  const mesh::Part part = support::whole_part(mesh);
  const auto size = static_cast<Eigen::Index>(mesh.nodes.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  const auto width = static_cast<std::size_t>(element::node_count(type));
  for (Index e = 0; e < mesh.element_count(); ++e) {
    std::vector<Vector3> reference;
    for (const Index node : mesh.element_nodes(e)) {
      reference.push_back(mesh.nodes[node]);
    }
    const Eigen::MatrixXd k =
        tangent_stiffness(type, elasticity(material), reference, std::vector<Vector3>(width, Vector3::Zero()));
    for (std::size_t a = 0; a < width; ++a) {
      for (std::size_t b = 0; b < width; ++b) {
        stiffness(mesh.element_nodes(e)[a], mesh.element_nodes(e)[b]) +=
            k(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b));
      }
    }
  }
  std::vector<double> mass(mesh.nodes.size());
  Solid(part.bodies[0], part.reference, material).add_mass(mass);
  Eigen::VectorXd inverse_root = Eigen::Map<Eigen::VectorXd>(mass.data(), size).cwiseSqrt().cwiseInverse();
  for (const Index node : mesh.groups.at("x0")) {
    inverse_root[node] = 0.0;  // clamped: its eigenvalue is zero
  }
  const Eigen::MatrixXd dynamic = inverse_root.asDiagonal() * stiffness * inverse_root.asDiagonal();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dynamic, Eigen::EigenvaluesOnly).eigenvalues();
  const auto clamped = static_cast<Eigen::Index>(mesh.groups.at("x0").size());
  return std::sqrt(values[clamped]) / (std::numbers::pi / 2) - 1;
}

TEST(BarFrequency, Tet4ConvergesWithSecondOrder) {
  const double coarse = frequency_error(element::tet4, 1);
  const double fine = frequency_error(element::tet4, 2);
  RecordProperty("order", std::to_string(std::log2(coarse / fine)));
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << coarse << " " << fine;
}

// The stiffness of a tet10 would give fourth order; its diagonal mass brings it down to second.
TEST(BarFrequency, Tet10WithDiagonalMassConvergesWithSecondOrder) {
  const double coarse = frequency_error(element::tet10, 1);
  const double fine = frequency_error(element::tet10, 2);
  RecordProperty("order", std::to_string(std::log2(coarse / fine)));
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.2) << coarse << " " << fine;
}

}  // namespace
}  // namespace idiophone::solid
