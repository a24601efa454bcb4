#include "modal_response.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

namespace idiophone::proxies {

namespace {

void check(const Lattice& lattice, std::span<const KnownMode> modes) {
  if (lattice.is_under_tension()) {
    throw std::invalid_argument("springs under tension can't be fitted");
  }
  if (modes.empty()) {
    throw std::invalid_argument("springs are fitted to one mode or more");
  }
  double previous = 0.0;
  for (const KnownMode& mode : modes) {
    if (mode.shape.size() != lattice.masses().size()) {
      throw std::invalid_argument("a mode has a displacement for each mass of the lattice");
    }
    if (!(mode.angular_frequency > 0.0) || mode.angular_frequency < previous) {
      throw std::invalid_argument("frequencies of modes are above 0 and ascending");
    }
    previous = mode.angular_frequency;
  }
}

/// The orthonormal vectors that are nearest to some vectors (P.-O. Lowdin, J. Chem. Phys. 18, 1950), if these differ.
std::optional<Eigen::MatrixXd> orthonormal(const Eigen::MatrixXd& vectors) {
  constexpr double least_part = 0.1;  // of the square of a vector that is in no other one
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> products(vectors.transpose() * vectors);
  if (!(products.eigenvalues()[0] >= least_part)) {
    return std::nullopt;
  }
  return vectors * products.operatorInverseSqrt();
}

Eigen::MatrixXd orthonormal_span(const Eigen::MatrixXd& vectors) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(vectors).householderQ() *
         Eigen::MatrixXd::Identity(vectors.rows(), vectors.cols());
}

using Cholesky = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

}  // namespace

ModalResponse::ModalResponse(const Lattice& lattice, std::span<const KnownMode> modes)
    : lattice_(lattice), masses_(lattice.pinned()) {
  constexpr double relative_shift = 1e-3;
  check(lattice, modes);
  roots_.resize(masses_.unknowns());
  for (std::size_t i = 0; i < lattice.masses().size(); ++i) {
    if (masses_.is_free(i)) {
      roots_.segment<3>(masses_.first(i)).setConstant(std::sqrt(lattice.masses()[i]));
    }
  }
  squares_.resize(std::ssize(modes));
  std::ranges::transform(modes, squares_.begin(),
                         [](const KnownMode& mode) { return std::pow(mode.angular_frequency, 2); });
  shift_ = relative_shift * squares_[0];
  rigid_ = rigid_motions();
  shapes_ = known_shapes(modes);
}

Eigen::MatrixXd ModalResponse::known_shapes(std::span<const KnownMode> modes) const {
  Eigen::MatrixXd shapes(masses_.unknowns(), std::ssize(modes));
  for (Index m = 0; m < std::ssize(modes); ++m) {
    for (std::size_t i = 0; i < modes[m].shape.size(); ++i) {
      if (masses_.is_free(i)) {
        shapes.col(m).segment<3>(masses_.first(i)) = modes[m].shape[i];
      }
    }
  }
  shapes = roots_.asDiagonal() * shapes;
  shapes = deformed(shapes.colwise().normalized());
  if (std::optional<Eigen::MatrixXd> different = orthonormal(shapes)) {
    return std::move(*different);
  }
  throw std::invalid_argument("its " + std::to_string(modes.size()) +
                              " modes look alike on the few masses of the lattice; it needs smaller elements");
}

/// What is left of vectors without their rigid motion.
Eigen::MatrixXd ModalResponse::deformed(const Eigen::MatrixXd& vectors) const {
  return vectors - rigid_ * (rigid_.transpose() * vectors);
}

Eigen::MatrixXd ModalResponse::rigid_motions() const {
  if (!lattice_.is_free()) {
    return Eigen::MatrixXd::Zero(masses_.unknowns(), 0);
  }
  const double length = std::sqrt(lattice_.inertia().second.trace() / lattice_.inertia().mass);
  Eigen::MatrixXd motions(masses_.unknowns(), 6);
  for (std::size_t i = 0; i < lattice_.masses().size(); ++i) {
    const Vector3 arm = (lattice_.mesh().nodes[i] - lattice_.inertia().centre) / length;
    for (Index axis = 0; axis < 3; ++axis) {
      motions.col(axis).segment<3>(masses_.first(i)) = Vector3::Unit(axis);
      motions.col(3 + axis).segment<3>(masses_.first(i)) = Vector3::Unit(axis).cross(arm);
    }
  }
  return orthonormal_span(roots_.asDiagonal() * motions);
}

/// K + shift M
Eigen::SparseMatrix<double> ModalResponse::shifted_stiffness(const Eigen::VectorXd& stiffness) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index s = 0; s < stiffness.size(); ++s) {
    const Spring& spring = lattice_.springs()[s];
    const Vector3 n = (lattice_.mesh().nodes[spring.b] - lattice_.mesh().nodes[spring.a]).normalized();
    masses_.add_spring(entries, spring, stiffness[s] * n * n.transpose());
  }
  for (Index i = 0; i < masses_.unknowns(); ++i) {
    entries.emplace_back(i, i, shift_ * roots_[i] * roots_[i]);
  }
  Eigen::SparseMatrix<double> matrix(masses_.unknowns(), masses_.unknowns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// [springs x columns of `displacements`]
Eigen::MatrixXd ModalResponse::elongations(const Eigen::MatrixXd& displacements) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(std::ssize(lattice_.springs()), displacements.cols());
  for (Eigen::Index s = 0; s < result.rows(); ++s) {
    const Spring& spring = lattice_.springs()[s];
    const Vector3 n = (lattice_.mesh().nodes[spring.b] - lattice_.mesh().nodes[spring.a]).normalized();
    for (const auto& [mass, sign] : {std::pair(spring.a, -1.0), std::pair(spring.b, 1.0)}) {
      if (masses_.is_free(mass)) {
        result.row(s) += sign * n.transpose() * displacements.middleRows<3>(masses_.first(mass));
      }
    }
  }
  return result;
}

Flexibility ModalResponse::flexibility(const Eigen::VectorXd& stiffness) const {
  const Cholesky factors(shifted_stiffness(stiffness));
  const Eigen::VectorXd frequencies = (squares_.array() + shift_).sqrt();
  const Eigen::MatrixXd forces = roots_.asDiagonal() * shapes_ * frequencies.asDiagonal();
  const Eigen::MatrixXd displacements = factors.solve(forces);
  return {.matrix = forces.transpose() * displacements, .elongations = elongations(displacements)};
}

Eigen::MatrixXd ModalResponse::elongations_of_shapes() const {
  const Eigen::VectorXd frequencies = squares_.cwiseSqrt();
  return elongations(roots_.cwiseInverse().asDiagonal() * shapes_ * frequencies.cwiseInverse().asDiagonal());
}

/// Of a lattice, ascending.
struct ModalResponse::OwnModes {
  Eigen::VectorXd squares;  ///< [modes] (rad/s)^2
  Eigen::MatrixXd vectors;  ///< [unknowns x modes] times the roots of the masses; orthonormal
};

/// By subspace iteration.
ModalResponse::OwnModes ModalResponse::own_modes(const Eigen::VectorXd& stiffness, Eigen::Index count) const {
  constexpr Eigen::Index more = 8;  // vectors than modes: the last ones converge slowly
  constexpr int most_rounds = 100;
  constexpr double enough = 1e-6;
  const Cholesky factors(shifted_stiffness(stiffness));
  Eigen::MatrixXd vectors(shapes_.rows(), std::min(count + more, shapes_.rows() - rigid_.cols()));
  std::mt19937 random(1);
  for (double& value : vectors.reshaped()) {
    value = static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5;
  }
  vectors.leftCols(shapes_.cols()) = shapes_;
  count = std::min(count, vectors.cols());
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(count);
  for (int round = 0; round < most_rounds; ++round) {
    vectors = orthonormal_span(deformed(vectors));
    const Eigen::MatrixXd next = roots_.asDiagonal() * factors.solve(roots_.asDiagonal() * vectors).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(vectors.transpose() * next);
    const Eigen::VectorXd before = std::move(squares);
    squares = ritz.eigenvalues().reverse().head(count).cwiseInverse().array() - shift_;
    vectors = next * ritz.eigenvectors().rowwise().reverse();
    if ((squares - before).cwiseAbs().cwiseQuotient(squares).maxCoeff() < enough) {
      break;
    }
  }
  return {.squares = squares, .vectors = orthonormal_span(vectors.leftCols(count))};
}

Eigen::VectorXd ModalResponse::lowest_squares(const Eigen::VectorXd& stiffness) const {
  return own_modes(stiffness, shapes_.cols()).squares;
}

void ModalResponse::turn_to_modes(const Eigen::VectorXd& stiffness) {
  const OwnModes own = own_modes(stiffness, shapes_.cols() + shapes_.cols() / 2);
  if (std::optional<Eigen::MatrixXd> turned = orthonormal(own.vectors * (own.vectors.transpose() * shapes_))) {
    shapes_ = std::move(*turned);
  }
}

}  // namespace idiophone::proxies
