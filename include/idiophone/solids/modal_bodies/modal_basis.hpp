#pragma once
// The modes of a body as data, from which a modal body is made. Module `eigenmodes` computes them.

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/modal_bodies/stretching.hpp"

namespace idiophone::modal_bodies {

/// Free vibrations of a body about its rest: how it is held counts, its supports do not. Of a body that others pull at
/// at rest, those of the unstressed body; but their damping is that of the taut one, where its stress stiffens them.
struct ModalBasis {
  bool is_free = false;  ///< it has six rigid motions; otherwise none
  std::vector<double>
      frequencies;  ///< [modes] w, rad/s, ascending: zeta does not count, but the stiffness that losses add does
  std::size_t further = 0;          ///< how many of them, the highest, joints add to those of the model
  std::vector<double> decay_rates;  ///< [modes] zeta w: amplitudes fall as exp(-zeta w t), 1/s
  /// [modes x 3 x nodes], mode by mode, kg^-1/2: x^T M x = 1. In a run, empty on ranks that do not have the body
  std::vector<double> shapes;
  std::vector<double> masses;  ///< [nodes] of the lumped mass matrix M, kg
  /// [nodes] Flexibility that the modes left out add at a node along its normal, m/N: the static displacement by a unit
  /// force there, less that of the modes above. Zero where no load, support or contact can act.
  std::vector<double> residual;
  /// [3 x nodes] displacements at rest among bodies that joints tie to it, m: displacements of the body contain them.
  /// Empty: they count from where the body rests by itself
  std::vector<double> rest;
  std::vector<double> rest_force;  ///< [modes] of its own stress there, which joints balance, N/kg^1/2; empty likewise
  std::vector<double> rest_stiffness;  ///< [modes x modes] that this stress adds to w^2, 1/s2; empty likewise
  double mass_damping = 0.0;           ///< alpha, 1/s; it slows rigid motion, too
  double thickness = 0.0;              ///< twice the volume over the surface, m
  /// Joined bodies with large amplitudes have the modes of their assembly in common: the number of its first body,
  /// which alone has the terms of stretching. Shapes and masses are those of this body's nodes, and x^T M x = 1 of all
  /// bodies.
  std::optional<std::size_t> common_with;
  Stretching stretching;  ///< of large vibrations; none where they are taken as small

  [[nodiscard]] std::size_t modes() const { return frequencies.size(); }
  [[nodiscard]] std::size_t nodes() const { return masses.size(); }
};

/// Those of the bodies that move by their modes, by the number of the body.
using ModalBases = std::map<std::size_t, ModalBasis>;

/// Frequency at which the residual flexibility may follow a force, rad/s: twice that of the model's highest mode, and
/// of 40 kHz at least, of 20 kHz where the modes stretch the body. A modal body's step resolves it.
[[nodiscard]] double residual_frequency(const ModalBasis& basis);

}  // namespace idiophone::modal_bodies
