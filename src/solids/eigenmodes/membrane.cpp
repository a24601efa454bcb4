#include "idiophone/solids/eigenmodes/membrane.hpp"

#include <Eigen/Dense>
#include <array>

#include "plane_problem.hpp"

namespace idiophone::eigenmodes {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Gradient6 = Eigen::Matrix<double, 6, 2>;

/// A point of the reference triangle, by its coordinates along the edges from corner 0.
struct TrianglePoint {
  double xi, eta, weight;
};

/// Six points, exact up to degree 4 (Dunavant 1985); the weights add up to 1/2.
constexpr std::array<TrianglePoint, 6> quadrature = [] {
  constexpr double a = 0.816847572980459, b = 0.091576213509771, first = 0.109951743655322 / 2;
  constexpr double c = 0.108103018168070, d = 0.445948490915965, second = 0.223381589678011 / 2;
  return std::array<TrianglePoint, 6>{
      {{b, b, first}, {a, b, first}, {b, a, first}, {d, d, second}, {c, d, second}, {d, c, second}}};
}();

/// Stiffness and mass of one element.
struct ElementMatrices {
  Matrix6 stiffness = Matrix6::Zero();
  Matrix6 mass = Matrix6::Zero();
};

ElementMatrices element_matrices(const mesh::PlaneMesh& mesh, const std::array<Index, 6>& nodes,
                                 const Membrane& membrane) {
  Eigen::Matrix<double, 6, 2> places;
  for (int a = 0; a < 6; ++a) {
    places.row(a) << mesh.nodes[nodes[a]][0], mesh.nodes[nodes[a]][1];
  }
  ElementMatrices matrices;
  for (const auto& [xi, eta, weight] : quadrature) {
    const double rest = 1 - xi - eta;
    Vector6 shape;
    shape << rest * (2 * rest - 1), xi * (2 * xi - 1), eta * (2 * eta - 1), 4 * rest * xi, 4 * xi * eta, 4 * eta * rest;
    Gradient6 slope;  // by xi and eta
    slope << 1 - 4 * rest, 1 - 4 * rest, 4 * xi - 1, 0, 0, 4 * eta - 1, 4 * (rest - xi), -4 * xi, 4 * eta, 4 * xi,
        -4 * eta, 4 * (rest - eta);
    const Eigen::Matrix2d jacobian = places.transpose() * slope;
    const double area = weight * jacobian.determinant();
    const Gradient6 gradient = slope * jacobian.inverse();
    const Eigen::Vector2d place = places.transpose() * shape;
    matrices.stiffness += membrane.tension(place[0], place[1]) * area * gradient * gradient.transpose();
    matrices.mass += membrane.density(place[0], place[1]) * area * shape * shape.transpose();
  }
  return matrices;
}

}  // namespace

std::vector<PlaneMode> membrane_modes(const mesh::PlaneMesh& mesh, const Membrane& membrane,
                                      const WantedModes& wanted) {
  std::vector<bool> held(mesh.nodes.size(), false);
  for (const mesh::RimEdge& edge : mesh.rim) {
    for (const Index node : {edge.ends[0], edge.ends[1], edge.middle}) {
      held[node] = true;
    }
  }
  PlaneProblem problem(held);
  for (const auto& nodes : mesh.elements) {
    const ElementMatrices matrices = element_matrices(mesh, nodes, membrane);
    problem.add(nodes, matrices.stiffness, matrices.mass);
  }
  problem.assemble();
  std::vector<PlaneMode> modes;
  for (Eigenpair& pair : wanted_eigenpairs(problem, "membrane", {}, wanted, 0.0)) {
    orient_shape(pair.vector);
    modes.push_back({frequency_of(pair.value), std::move(pair.vector)});
  }
  return modes;
}

}  // namespace idiophone::eigenmodes
