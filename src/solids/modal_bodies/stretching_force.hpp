#pragma once
// The force of stretching on the modes, in time.

#include <Eigen/Core>

#include "idiophone/solids/modal_bodies/stretching.hpp"

namespace idiophone::modal_bodies {

/// A step of all modes together, of which `end` is where the linear recurrence alone takes them.
struct ModalStep {
  const Eigen::ArrayXd& before;     ///< [modes] q_{n-1}, kg^1/2 m
  const Eigen::ArrayXd& now;        ///< [modes] q_n
  const Eigen::ArrayXd& end;        ///< [modes]
  const Eigen::ArrayXd& stiffness;  ///< [modes] force on a mode that would move its end by 1, 1/s^2
};

/// In a step, the force is that of the discrete energy
///   sum_n (a_n z_n + 1/2 z_n^2),  a_n = A_n . (q_n + q_{n+1})/2,  z_n = q_n . H_n q_{n+1},
/// which is conserved together with that of the linear recurrence. Both are a sum of squares, so steps of any length
/// are stable (docs/method/large_amplitudes.md). The force depends linearly on q_{n+1}: a step solves linear equations
/// of as many unknowns as modes.
class StretchingForce {
 public:
  /// Of small vibrations: none.
  StretchingForce() = default;
  explicit StretchingForce(const Stretching& stretching);

  [[nodiscard]] bool exists() const { return terms_ > 0; }

  /// At one place, N/kg^1/2. [modes]
  [[nodiscard]] Eigen::ArrayXd at(const Eigen::ArrayXd& places) const;

  /// At one place, J.
  [[nodiscard]] double energy(const Eigen::ArrayXd& places) const;

  /// By how much the force changes the end of a step, kg^1/2 m. [modes]
  [[nodiscard]] Eigen::ArrayXd change_of_end(const ModalStep& step) const;

  /// Memory, bytes.
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// H_n q of all terms. [modes x terms]
  [[nodiscard]] Eigen::MatrixXd products(const Eigen::ArrayXd& places) const;

  Eigen::Index terms_ = 0;
  Eigen::MatrixXd linear_;         ///< A, [modes x terms]
  Eigen::MatrixXd quadratic_;      ///< H, [modes, modes x terms]
  Eigen::MatrixXd linear_square_;  ///< sum_n A_n A_n^T, [modes x modes]
};

}  // namespace idiophone::modal_bodies
