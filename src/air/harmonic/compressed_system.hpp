#pragma once
// Burton and Miller's equations without the full matrix: the precorrected fast Fourier transform (Phillips and White
// 1997). Each shape function is represented by charges on the nodes of a grid around its vertex; the sound from node to
// node is a convolution. For pairs of near vertices the grid is not exact: a sparse matrix holds the difference between
// Galerkin's integrals and the grid.

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <vector>

#include "burton_miller.hpp"
#include "convolution_grid.hpp"
#include "grid_receivers.hpp"

namespace idiophone::harmonic {

class CompressedSystem {
 public:
  /// @param longest_edge  of the panels, m
  /// @throws std::runtime_error if the grid is too large
  CompressedSystem(const Equations& equations, std::span<const PointSource> sources, double longest_edge);

  /// [vertices x motions]
  [[nodiscard]] const Eigen::MatrixXcd& right_sides() const { return right_sides_; }

  /// result = matrix pressure
  void multiply(const Eigen::Ref<const Eigen::VectorXcd>& pressure, Eigen::Ref<Eigen::VectorXcd> result);

  /// result is about the solution of matrix result = residual: incomplete LU factors of the entries of close
  /// neighbours.
  void precondition(const Eigen::Ref<const Eigen::VectorXcd>& residual, Eigen::Ref<Eigen::VectorXcd> result) const;

 private:
  using SparseMatrix = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

  void find_dipoles();
  [[nodiscard]] std::vector<std::vector<Stencil>> slope_charges() const;
  void make_pattern();
  void add_panel_pairs(const Receiver& receiver);
  void subtract_grid(const Receiver& receiver, const std::vector<std::vector<Stencil>>& slopes);
  void add_grid_right_sides(const std::vector<std::vector<Stencil>>& slopes);
  void factorise(double longest_edge);
  void scatter(const Stencil& stencil, Complex factor, std::span<Complex> charges) const;
  [[nodiscard]] Complex gather(const Stencil& stencil, std::span<const Complex> potentials) const;

  const Equations& equations_;
  Grid grid_;
  std::vector<Receiver> receivers_;
  std::vector<Stencil> dipoles_;  ///< of each vertex: double layer of N_b
  SparseMatrix matrix_;           ///< entries of near vertices: exact minus grid
  Eigen::MatrixXcd right_sides_;
  GridConvolution convolution_;
  Eigen::IncompleteLUT<Complex> factors_;
};

}  // namespace idiophone::harmonic
