#pragma once
// The force of stretching on the modes, in time.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "idiophone/foundation/stretching/stretching_energy.hpp"
#include "idiophone/solids/modal_bodies/stretching.hpp"

namespace idiophone::modal_bodies {

/// A step of all modes together, of which `end` is where the linear recurrence alone takes them.
struct ModalStep {
  double length;                    ///< s
  const Eigen::ArrayXd& before;     ///< [modes] q_{n-1}, kg^1/2 m
  const Eigen::ArrayXd& now;        ///< [modes] q_n
  const Eigen::ArrayXd& end;        ///< [modes]
  const Eigen::ArrayXd& stiffness;  ///< [modes] kappa, force on a mode that would move its end by 1, 1/s^2
  const Eigen::ArrayXd& squares;    ///< [modes] w^2, 1/s^2
};

/// What the force of stretching does in a step.
struct StretchedStep {
  Eigen::ArrayXd change;  ///< [modes] of the end of the step, kg^1/2 m
  double stored;          ///< p^2/2 - offset after the step, J
};

/// The force is -g p, g the gradient of p = sqrt(2 (V + offset)) at q_n, V the energy of stretching. p is known in the
/// middle of steps, and goes on by g . (q_{n+1} - q_{n-1})/2; the force has the mean of both. So p^2/2 - offset and the
/// discrete energy of the linear recurrence always have the same sum, for steps of any length (the scalar auxiliary
/// variable of J. Shen, J. Xu and J. Yang, J. Comput. Phys. 353, 2018; explicit: S. Bilbao, M. Ducceschi and F. Zama,
/// J. Comput. Phys. 472, 2023; docs/method/large_amplitudes.md).
class StretchingForce {
 public:
  /// Of small vibrations: none.
  StretchingForce() = default;
  explicit StretchingForce(const Stretching& stretching);

  [[nodiscard]] bool exists() const { return energy_.has_value(); }

  /// Finds energy and force at a place of the modes, q_n. [modes]
  void go_to(const Eigen::ArrayXd& places);
  [[nodiscard]] double energy() const { return value_; }             ///< V at that place, J
  [[nodiscard]] Eigen::ArrayXd force() const { return -gradient_; }  ///< there, N/kg^1/2. [modes]

  /// A step from that place.
  /// @param stored  p^2/2 - offset in the middle of the step before, J
  [[nodiscard]] StretchedStep step(const ModalStep& step, double stored) const;

  /// Memory, bytes.
  [[nodiscard]] std::size_t bytes() const { return energy_ ? energy_->bytes() : 0; }

 private:
  std::optional<stretching::StretchingEnergy> energy_;
  std::vector<float> places_, slopes_;  // [modes]
  double value_ = 0.0;                  // V, J
  Eigen::ArrayXd gradient_;             // [modes] of V
};

}  // namespace idiophone::modal_bodies
