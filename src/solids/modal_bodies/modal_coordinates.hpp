#pragma once
// The coordinates of a body's modes. Their linear motion is stepped exactly; where they stretch the body, its energy
// is.

#include <Eigen/Core>
#include <span>

#include "idiophone/foundation/parallel/archive_row.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "stretching_force.hpp"

namespace idiophone::modal_bodies {

using motion::Step;

class ModalCoordinates {
 public:
  ModalCoordinates() = default;
  /// At rest.
  explicit ModalCoordinates(const ModalBasis& basis);

  /// Sets the state at time 0. [modes]
  void start(const Eigen::ArrayXd& places, const Eigen::ArrayXd& rates);

  /// Prepares for steps of a length, s. `advance` does so, too.
  void prepare(double length);

  /// Goes on from restored coordinates, after a step of a length, s.
  void restored(double length);

  /// From t_n to t_{n+1}.
  /// @param force  [modes] at t_n, N/kg^1/2
  void advance(const Step& step, const Eigen::ArrayXd& force);

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(places_.size()); }
  [[nodiscard]] const Eigen::ArrayXd& places() const { return places_; }  ///< [modes] q_n, kg^1/2 m
  [[nodiscard]] const Eigen::ArrayXd& rates() const { return rates_; }    ///< [modes] over the last step, kg^1/2 m/s

  /// Rates at t_n, [modes], for a step as long as the last one, which is prepared. Arguments as for `advance`.
  [[nodiscard]] Eigen::ArrayXd rates_now(const Step& step, const Eigen::ArrayXd& force) const;

  [[nodiscard]] double elastic_energy() const;  ///< J
  /// What the last step left of the energy of stretching, J: with the discrete energy of the recurrences it is
  /// conserved.
  [[nodiscard]] double stored_energy() const { return stored_; }

  /// Whether the modes stretch the body, so that they depend on each other.
  [[nodiscard]] bool stretch() const { return stretching_.exists(); }
  [[nodiscard]] std::size_t bytes() const { return stretching_.bytes(); }  ///< memory of the force of stretching

  void archive(std::size_t mode, parallel::ArchiveRow& row);
  void archive_stored_energy(parallel::ArchiveRow& row) { row.value(stored_); }

 private:
  /// What the next step, as long as the last one, leaves.
  struct Next {
    Eigen::ArrayXd rates;  ///< [modes] over it
    double stored;         ///< as StretchedStep
  };
  [[nodiscard]] Next next(const Eigen::ArrayXd& force) const;

  Eigen::ArrayXd frequencies_;    ///< [modes] w without damping, rad/s
  Eigen::ArrayXd decays_;         ///< [modes] 1/s
  Eigen::ArrayXd squares_;        ///< [modes] w^2, 1/s^2
  Eigen::ArrayXd flexibilities_;  ///< [modes] 1/w^2, s^2
  double length_ = 0.0;           ///< of the steps prepared, s
  Eigen::ArrayXd keep_;           ///< [modes] as OscillatorStep
  Eigen::ArrayXd pull_;           ///< likewise
  Eigen::ArrayXd stiffness_;      ///< [modes] as ModalStep
  StretchingForce stretching_;    ///< at the places
  double stored_ = 0.0;           ///< as StretchedStep
  Eigen::ArrayXd places_;
  Eigen::ArrayXd rates_;
};

}  // namespace idiophone::modal_bodies
