#pragma once
// How a body stretches where its vibrations are large (docs/method/large_amplitudes.md).

#include <cstddef>
#include <vector>

namespace idiophone::modal_bodies {

/// Green's strain is of second order in the modal coordinates q (kg^1/2 m). What static stretching cannot relieve of it
/// has the components z_n = q . H_n q along strains s_n that are orthonormal in the energy, and the linear strain of
/// the modes has the components a_n = A_n . q. The elastic energy is
///   V = 1/2 sum w^2 q^2 + sum_n (a_n z_n + 1/2 z_n^2).
struct Stretching {
  std::vector<double> linear;     ///< [terms x modes] A, J^1/2/(kg^1/2 m)
  std::vector<double> quadratic;  ///< [terms x modes x modes] H, symmetric in the modes, J^1/2/(kg m2)
  std::vector<double> rotation;   ///< [modes x modes] T: q . T q is the mean square of the rotation angle in the body

  [[nodiscard]] bool exists() const { return !rotation.empty(); }
  [[nodiscard]] std::size_t terms() const {
    return linear.empty() ? 0 : linear.size() * linear.size() / quadratic.size();
  }
  /// Of fewer modes: the first ones.
  [[nodiscard]] Stretching of_first(std::size_t modes) const;
};

}  // namespace idiophone::modal_bodies
