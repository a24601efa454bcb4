#pragma once
// What elements of one material remember of their strain: the state of a generalised Maxwell solid at finite strain
// (Simo, Computer Methods in Applied Mechanics and Engineering 60, 1987).
//
// Each mechanism holds an overstrain Q, with Q' + rate Q = strength E' at every quadrature point; the second
// Piola-Kirchhoff stress is C (long_term E + sum of Q + beta E'). As all mechanisms share C, strains are kept in place
// of stresses. Over a step in which E changes evenly this has the exact solution Q_n = keep Q_{n-1} + gain (E_n -
// E_{n-1}).

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"
#include "idiophone/solids/solid/pack.hpp"
#include "idiophone/solids/solid/pack_layout.hpp"
#include "idiophone/solids/solid/relaxation.hpp"

namespace idiophone::solid {

class Memory {
 public:
  struct MechanismStep {
    double keep;      ///< exp(-rate step)
    double gain;      ///< strength (1 - exp(-rate step))/(rate step)
    double strength;  ///< as in Relaxation
  };

  /// Of packs of elements that have always rested.
  /// @param beta    damping proportional to stiffness, s
  /// @param step    dt, s
  /// @param points  quadrature points of an element
  Memory(const Relaxation& relaxation, double beta, double step, PackRange packs, std::size_t points);

  [[nodiscard]] double step() const { return step_; }            ///< s
  [[nodiscard]] double long_term() const { return long_term_; }  ///< modulus at frequency 0, without unit
  [[nodiscard]] double damping() const { return damping_; }      ///< beta over the step, without unit
  [[nodiscard]] std::span<const MechanismStep> mechanisms() const { return mechanisms_; }

  /// Overstrains of the elements of a pack at one quadrature point after the step before the present one. [mechanisms]
  /// @param place  pack times points of an element plus point
  [[nodiscard]] PackSymmetric* at(std::size_t place) { return &overstrain_[(place - first_) * mechanisms_.size()]; }
  [[nodiscard]] const PackSymmetric* at(std::size_t place) const {
    return &overstrain_[(place - first_) * mechanisms_.size()];
  }

  [[nodiscard]] std::size_t bytes() const { return overstrain_.size() * sizeof(PackSymmetric); }

  /// The overstrains of the element in a lane of a pack: quadrature points x mechanisms x 6.
  void archive(std::size_t pack, std::size_t lane, parallel::ArchiveRow& row);

 private:
  double step_;
  double long_term_;
  double damping_;
  std::size_t points_;
  std::size_t first_;  ///< place of the first pack's first point
  std::vector<MechanismStep> mechanisms_;
  std::vector<PackSymmetric> overstrain_;  ///< [mechanisms x quadrature points x packs]
};

}  // namespace idiophone::solid
