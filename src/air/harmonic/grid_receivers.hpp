#pragma once
// How the vertices of a boundary hear charges on the nodes of a grid, and which of them are too near for the grid.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "burton_miller.hpp"
#include "convolution_grid.hpp"

namespace idiophone::harmonic {

/// A linear function of a field on the grid, or charges there.
struct Stencil {
  std::array<int, 3> middle = {};
  Eigen::VectorXcd weights;  ///< [Grid::stencil_size()]
};

/// The boundary, or its mirror image, as receiver.
struct Receiver {
  double gain = 1.0;  ///< reflection
  std::vector<Panel> panels;
  std::vector<Vector3> places;                  ///< of the vertices
  std::vector<Stencil> tests;                   ///< of each vertex: integral of N_a (1 + alpha d/dn)
  std::vector<std::vector<Index>> vertices;     ///< near each vertex, ascending
  std::vector<std::vector<Index>> panels_near;  ///< that touch one of them, ascending
};

/// The vertices, and behind them their mirror images if there is a floor.
[[nodiscard]] std::vector<Vector3> vertices_and_images(const Boundary& boundary);

/// The boundary, and its mirror image if there is a floor.
[[nodiscard]] std::vector<Receiver> receivers_of(const Equations& equations, const Grid& grid);

}  // namespace idiophone::harmonic
