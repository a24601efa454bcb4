#pragma once
// The mass of a modal body: how rigid motion and modes share it.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "modal_shapes.hpp"

namespace idiophone::modal_bodies {

class ModalInertia {
 public:
  ModalInertia() = default;
  /// @param masses     [nodes] kg
  /// @param reference  [nodes] X, m
  ModalInertia(std::span<const double> masses, std::span<const Vector3> reference, const ModalShapes& shapes);

  /// What a mode has to do with rigid motion.
  struct Moments {
    Vector3 momentum;       ///< sum m phi, kg^1/2; zero of a free body
    Vector3 angular;        ///< sum m (X - C) x phi, kg^1/2 m; likewise
    Eigen::Matrix3d cross;  ///< sum m phi (X - C)^T, kg^1/2 m
  };

  [[nodiscard]] std::span<const double> masses() const { return masses_; }        ///< [nodes] kg
  [[nodiscard]] std::span<const Vector3> arms() const { return arms_; }           ///< [nodes] X - C, m
  [[nodiscard]] double mass() const { return mass_; }                             ///< kg
  [[nodiscard]] const Eigen::Matrix3d& second_moment() const { return moment_; }  ///< about the centre, kg m2
  [[nodiscard]] Eigen::Matrix3d inverse_inertia() const;                          ///< 1/(kg m2)
  [[nodiscard]] const Moments& moments(std::size_t mode) const { return moments_[mode]; }

  /// Of the second moment by the vibration, kg m2.
  /// @param places  [modes] kg^1/2 m
  [[nodiscard]] Eigen::Matrix3d change_of_moment(const Eigen::ArrayXd& places) const;

  /// Adds what a held body's weight does to the modes.
  /// @param modal  [modes] N/kg^1/2
  void add_weight(const Vector3& gravity, Eigen::ArrayXd& modal) const;

  /// Adds what the centrifugal forces of a free body do to the modes.
  /// @param spin   in the body's frame, rad/s
  /// @param modal  [modes] N/kg^1/2
  void add_centrifugal(const Vector3& spin, Eigen::ArrayXd& modal) const;

  /// How a force at each node accelerates it at once by rigid motion and the modes, 1/kg. [nodes]
  /// @param is_free  whether the body moves rigidly
  [[nodiscard]] std::vector<Eigen::Matrix3d> mobilities(const ModalShapes& shapes, bool is_free) const;

  /// The largest eigenvalue of springs from the nodes to the ground among rigid motion and the modes, (rad/s)^2.
  /// @param springs  [nodes] N/m; of dashpots (N s/m), the eigenvalue is in 1/s
  [[nodiscard]] double largest_eigenvalue(const ModalShapes& shapes, bool is_free,
                                          std::span<const double> springs) const;

 private:
  std::vector<double> masses_;
  std::vector<Vector3> arms_;
  double mass_ = 0.0;
  Eigen::Matrix3d moment_ = Eigen::Matrix3d::Zero();
  std::vector<Moments> moments_;  ///< [modes]
  /// [modes] How the second moment changes with a mode, cross + cross^T as xx, yy, zz, yz, xz, xy, kg^1/2 m
  Eigen::Matrix<double, 6, Eigen::Dynamic> changes_;
};

}  // namespace idiophone::modal_bodies
