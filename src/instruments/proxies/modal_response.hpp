#pragma once
// How the masses of a lattice answer the inertial forces of modes that its body has.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "free_masses.hpp"
#include "idiophone/instruments/proxies/lattice.hpp"
#include "idiophone/instruments/proxies/spring_fit.hpp"

namespace idiophone::proxies {

/// The flexibility of a lattice against its modes, and what springs do in it.
struct Flexibility {
  Eigen::MatrixXd matrix;       ///< [modes x modes] w_i w_j x_i^T M K^-1 M x_j; the identity if it has these modes
  Eigen::MatrixXd elongations;  ///< [springs x modes] for w_i M x_i, m
};

class ModalResponse {
 public:
  /// The shapes lose their rigid motion and become orthonormal by as small a change as possible (Lowdin 1950).
  /// @throws std::invalid_argument as fit_springs()
  ModalResponse(const Lattice& lattice, std::span<const KnownMode> modes);

  /// @param stiffness  of the springs, N/m
  [[nodiscard]] Flexibility flexibility(const Eigen::VectorXd& stiffness) const;

  /// [springs x modes] for x_i/w_i: the energies that the shapes store are the identity if the lattice has these modes.
  [[nodiscard]] Eigen::MatrixXd elongations_of_shapes() const;

  /// Squares of the lowest angular frequencies, as many as modes. Ascending, (rad/s)^2
  [[nodiscard]] Eigen::VectorXd lowest_squares(const Eigen::VectorXd& stiffness) const;

  /// Turns the shapes into the space of the lattice's own lowest modes, so that its flexibility against them tells its
  /// frequencies exactly. Shapes that these modes do not have stay as they are, and all others with them.
  void turn_to_modes(const Eigen::VectorXd& stiffness);

  [[nodiscard]] const Eigen::VectorXd& known_squares() const { return squares_; }  ///< (rad/s)^2

 private:
  struct OwnModes;
  [[nodiscard]] OwnModes own_modes(const Eigen::VectorXd& stiffness, Eigen::Index count) const;
  [[nodiscard]] Eigen::MatrixXd known_shapes(std::span<const KnownMode> modes) const;
  [[nodiscard]] Eigen::MatrixXd rigid_motions() const;
  [[nodiscard]] Eigen::MatrixXd deformed(const Eigen::MatrixXd& vectors) const;
  [[nodiscard]] Eigen::SparseMatrix<double> shifted_stiffness(const Eigen::VectorXd& stiffness) const;
  [[nodiscard]] Eigen::MatrixXd elongations(const Eigen::MatrixXd& displacements) const;

  const Lattice& lattice_;
  FreeMasses masses_;
  Eigen::VectorXd roots_;    ///< [unknowns] of the masses, kg^(1/2)
  Eigen::VectorXd squares_;  ///< [modes] (rad/s)^2
  double shift_ = 0.0;       ///< of all squares, so that the stiffness of a free body can be inverted, (rad/s)^2
  Eigen::MatrixXd rigid_;    ///< [unknowns x 6, or x 0 of a held body] times the roots of the masses; orthonormal
  Eigen::MatrixXd shapes_;   ///< [unknowns x modes] the same of the known modes
};

}  // namespace idiophone::proxies
