#pragma once
// The potential that charges on one stencil make at the nodes around it, node by node.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "convolution_grid.hpp"

namespace idiophone::harmonic {

class LocalPotential {
 public:
  LocalPotential(const Grid& grid, double wave_number) : grid_(grid), wave_number_(wave_number) {}

  /// @param middle, charges  of the stencil
  /// @param others           middles of all stencils where the potential is needed, at least one
  void compute(const std::array<int, 3>& middle, const Eigen::VectorXcd& charges,
               const std::vector<const std::array<int, 3>*>& others);

  /// Sum over the nodes of another stencil of its weights times the potential.
  [[nodiscard]] std::complex<double> gather(const std::array<int, 3>& middle, const Eigen::VectorXcd& weights) const;

 private:
  /// Real and imaginary parts.
  struct Parts {
    std::vector<double> real, imaginary;
  };
  void tabulate(int half_width);
  [[nodiscard]] std::size_t place(const std::array<int, 3>& node) const {
    return (static_cast<std::size_t>(node[0] - first_[0]) * count_[1] + (node[1] - first_[1])) * count_[2] +
           (node[2] - first_[2]);
  }

  const Grid& grid_;
  double wave_number_;
  int half_width_ = -1;  // of the table
  Parts green_;          // by the difference of two nodes
  std::array<int, 3> first_ = {}, count_ = {};
  Parts potential_;
};

}  // namespace idiophone::harmonic
