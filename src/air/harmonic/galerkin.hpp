#pragma once
// Galerkin's integrals over two panels.

#include <Eigen/Core>

#include "panel.hpp"

namespace idiophone::harmonic {

/// Double integrals of an outer panel's shape functions N_a (rows) and an inner one's N_b (columns).
struct PanelPair {
  Eigen::Matrix3cd single_layer = Eigen::Matrix3cd::Zero();  ///< of N_a N_b G
  Eigen::Matrix3cd double_layer = Eigen::Matrix3cd::Zero();  ///< of N_a N_b dG/dn, n the inner panel's normal
};

/// The inner integral is that of layer_potentials(). The outer one is by quadrature; near the inner panel it is cut
/// into four again and again, until each piece is smaller than its distance from the inner panel, at most four times.
[[nodiscard]] PanelPair panel_pair(const Panel& outer, const Panel& inner, double wave_number);

/// Integral of N_a N_b over one panel, m2.
[[nodiscard]] Eigen::Matrix3d panel_mass(const Panel& panel);

}  // namespace idiophone::harmonic
