#pragma once
// The frame that a free modal body vibrates in: Tisserand's, in which the vibration has no momentum and no angular
// momentum, since modes are orthogonal to rigid motions (Shabana, Dynamics of Multibody Systems, section 5).

#include <Eigen/Geometry>

#include "idiophone/solids/motion/body_model.hpp"

namespace idiophone::modal_bodies {

using motion::Step;

/// Where the frame is, and how it moves. Momenta are the state, so that forces alone change them.
class FloatingFrame {
 public:
  FloatingFrame() = default;
  /// @param mass     kg
  /// @param moment   second moment of mass of the undeformed body about its centre, kg m2
  /// @param damping  alpha, 1/s
  FloatingFrame(double mass, Eigen::Matrix3d moment, double damping, Vector3 gravity);

  void start(const Vector3& shift, const Eigen::Quaterniond& orientation, const Vector3& velocity, const Vector3& spin);

  /// From t_n to t_{n+1}.
  /// @param force   N
  /// @param torque  about the centre, N m
  /// @param change  of the second moment by the vibration, in the frame, kg m2
  void advance(const Step& step, const Vector3& force, const Vector3& torque, const Eigen::Matrix3d& change);

  /// How the body moves at one time.
  struct Motion {
    Vector3 velocity;          ///< of the centre, m/s
    Vector3 angular_momentum;  ///< about the centre, kg m2/s
    Vector3 spin;              ///< angular velocity, rad/s
  };
  /// At t_n. Arguments as for `advance`.
  [[nodiscard]] Motion now(const Step& step, const Vector3& force, const Vector3& torque,
                           const Eigen::Matrix3d& change) const;

  [[nodiscard]] const Vector3& shift() const { return shift_; }                     ///< of the centre, m
  [[nodiscard]] const Eigen::Matrix3d& turn() const { return turn_; }               ///< R
  [[nodiscard]] const Eigen::Matrix3d& turn_less_one() const { return less_one_; }  ///< R - 1, small to rounding
  [[nodiscard]] const Vector3& velocity() const { return velocity_; }               ///< at t_{n-1/2}, m/s
  [[nodiscard]] const Vector3& spin() const { return spin_; }                       ///< at t_{n-1/2}, rad/s
  /// Angular velocity in the frame, rad/s.
  [[nodiscard]] Vector3 own_spin() const { return turn_.transpose() * spin_; }

  void archive(parallel::ArchiveRow& row);

 private:
  void orient();

  double mass_ = 0.0;
  Eigen::Matrix3d moment_ = Eigen::Matrix3d::Zero();
  double damping_ = 0.0;
  Vector3 gravity_ = Vector3::Zero();
  Vector3 shift_ = Vector3::Zero();
  Vector3 velocity_ = Vector3::Zero();
  Vector3 angular_momentum_ = Vector3::Zero();  ///< about the centre, kg m2/s
  Vector3 spin_ = Vector3::Zero();
  Eigen::Quaterniond orientation_ = Eigen::Quaterniond::Identity();
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d less_one_ = Eigen::Matrix3d::Zero();
};

}  // namespace idiophone::modal_bodies
