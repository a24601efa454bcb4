#include "masses.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace idiophone::proxies {

namespace {

constexpr double smallest_share = 0.25;  // of a lumped mass that the correction leaves
using Linear = Eigen::Vector4d;
using Quadratic = Eigen::Matrix<double, 6, 1>;

Linear linear_at(const Vector3& x) {
  return {1.0, x[0], x[1], x[2]};
}

Quadratic components(const Eigen::Matrix3d& symmetric) {
  Quadratic six;
  six << symmetric(0, 0), symmetric(0, 1), symmetric(0, 2), symmetric(1, 1), symmetric(1, 2), symmetric(2, 2);
  return six;
}

/// Quadratic functions at the masses, less their regression on linear ones: masses that change in proportion to them
/// keep their sum and their centre.
std::vector<Quadratic> quadratics(std::span<const Vector3> positions, std::span<const double> masses) {
  Eigen::Matrix4d linear = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 6, 4> mixed;
  mixed.setZero();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const Linear l = linear_at(positions[i]);
    linear += masses[i] * l * l.transpose();
    mixed += masses[i] * components(positions[i] * positions[i].transpose()) * l.transpose();
  }
  const Eigen::Matrix<double, 6, 4> regression = mixed * linear.inverse();
  std::vector<Quadratic> quadratics;
  for (const Vector3& x : positions) {
    quadratics.emplace_back(components(x * x.transpose()) - regression * linear_at(x));
  }
  return quadratics;
}

/// Inverse of a symmetric matrix where its eigenvalues are not negligible.
Eigen::Matrix<double, 6, 6> pseudo_inverse(const Eigen::Matrix<double, 6, 6>& matrix, double scale) {
  constexpr double negligible = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix);
  Quadratic inverse = Quadratic::Zero();
  for (Index i = 0; i < 6; ++i) {
    if (solver.eigenvalues()[i] > negligible * scale) {
      inverse[i] = 1.0 / solver.eigenvalues()[i];
    }
  }
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

double signed_volume(const std::vector<Vector3>& nodes, const std::array<Index, 4>& tetrahedron) {
  const Vector3& a = nodes[tetrahedron[0]];
  const Vector3 b = nodes[tetrahedron[1]] - a, c = nodes[tetrahedron[2]] - a, d = nodes[tetrahedron[3]] - a;
  return b.cross(c).dot(d) / 6.0;
}

std::vector<double> volumes(const TetrahedralMesh& mesh) {
  std::vector<double> volumes;
  for (const auto& tetrahedron : mesh.tetrahedra) {
    for (const Index node : tetrahedron) {
      if (node < 0 || static_cast<std::size_t>(node) >= mesh.nodes.size()) {
        throw std::invalid_argument("a tetrahedron has the node " + std::to_string(node) + ", which is not there");
      }
    }
    const Vector3& a = mesh.nodes[tetrahedron[0]];
    const double volume = std::abs(signed_volume(mesh.nodes, tetrahedron));
    const auto length_to = [&](std::size_t corner) { return (mesh.nodes[tetrahedron[corner]] - a).norm(); };
    if (!(volume > 1e-9 * length_to(1) * length_to(2) * length_to(3))) {
      throw std::invalid_argument("tetrahedron " + std::to_string(volumes.size()) + " is flat");
    }
    volumes.push_back(volume);
  }
  return volumes;
}

Inertia inertia_of(std::span<const Vector3> positions, std::span<const double> masses) {
  Inertia inertia;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    inertia.mass += masses[i];
    inertia.centre += masses[i] * positions[i];
  }
  inertia.centre /= inertia.mass;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const Vector3 arm = positions[i] - inertia.centre;
    inertia.second += masses[i] * arm * arm.transpose();
  }
  return inertia;
}

Inertia inertia_of(const TetrahedralMesh& mesh, std::span<const double> volumes, double density) {
  Inertia inertia;
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    inertia.mass += density * volumes[t];
    for (const Index node : mesh.tetrahedra[t]) {
      inertia.centre += 0.25 * density * volumes[t] * mesh.nodes[node];
    }
  }
  inertia.centre /= inertia.mass;
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    Vector3 sum = Vector3::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Index node : mesh.tetrahedra[t]) {
      const Vector3 arm = mesh.nodes[node] - inertia.centre;
      sum += arm;
      squares += arm * arm.transpose();
    }
    inertia.second += density * volumes[t] / 20.0 * (squares + sum * sum.transpose());
  }
  return inertia;
}

std::vector<double> point_masses(const TetrahedralMesh& mesh, std::span<const double> volumes, double density,
                                 const Inertia& body) {
  std::vector<double> masses(mesh.nodes.size());
  for (std::size_t t = 0; t < volumes.size(); ++t) {
    for (const Index node : mesh.tetrahedra[t]) {
      masses[node] += 0.25 * density * volumes[t];
    }
  }
  const double length = std::sqrt(body.second.trace() / body.mass);
  std::vector<Vector3> positions;
  for (const Vector3& node : mesh.nodes) {
    positions.emplace_back((node - body.centre) / length);
  }
  const std::vector<Quadratic> functions = quadratics(positions, masses);
  Eigen::Matrix<double, 6, 6> products;
  products.setZero();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    products += masses[i] * functions[i] * functions[i].transpose();
  }
  const Inertia points = inertia_of(mesh.nodes, masses);
  const Quadratic factors =
      pseudo_inverse(products, body.mass) * components((points.second - body.second) / (length * length));
  double largest = 0.0;  // share that a mass loses
  for (const Quadratic& function : functions) {
    largest = std::max(largest, factors.dot(function));
  }
  const double reduction = largest > 1.0 - smallest_share ? (1.0 - smallest_share) / largest : 1.0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    masses[i] *= 1.0 - reduction * factors.dot(functions[i]);
  }
  return masses;
}

}  // namespace idiophone::proxies
