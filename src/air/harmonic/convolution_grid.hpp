#pragma once
// Sources and receivers on a regular grid, and the sound between all its nodes by fast Fourier transforms.

#include <fftw3.h>

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::harmonic {

/// Nodes at origin + spacing (i, j, k).
struct Grid {
  Vector3 origin = Vector3::Zero();  ///< m
  double spacing = 0.0;              ///< m
  std::array<int, 3> nodes = {};     ///< along each axis
  int reach = 2;                     ///< nodes of a stencil on each side of its middle

  /// Of a stencil along each axis.
  [[nodiscard]] int width() const { return 2 * reach + 1; }
  /// Nodes of a stencil.
  [[nodiscard]] int stencil_size() const { return width() * width() * width(); }
  /// The node nearest to a point: the middle of its stencil.
  [[nodiscard]] std::array<int, 3> nearest(const Vector3& point) const;
};

/// A grid for points with stencils of elements with these edges, fine enough for the wave number.
[[nodiscard]] Grid grid_about(std::span<const Vector3> points, double longest_edge, double wave_number);

/// Lagrange's polynomials of a stencil at a point, and their derivatives along a direction: a function f of the nodes
/// has at the point the value sum f value and the derivative sum f slope.
struct Interpolation {
  Eigen::VectorXd value;  ///< [stencil_size()], z fastest
  Eigen::VectorXd slope;  ///< likewise, 1/m
};

/// @param middle  of the stencil
[[nodiscard]] Interpolation interpolate(const Grid& grid, const std::array<int, 3>& middle, const Vector3& point,
                                        const Vector3& direction);

/// G = exp(-i k r)/(4 pi r) between nodes that are so far apart; 0 from a node to itself.
[[nodiscard]] std::complex<double> grid_green(const Grid& grid, double wave_number, int i, int j, int k);

/// The sum over all nodes of charge times G, at all nodes. Plans are FFTW's estimates, so the bits are always the same.
class GridConvolution {
 public:
  GridConvolution(const Grid& grid, double wave_number);

  /// The padded array, to be filled with charges; padding is zero. @return [padded nodes]
  [[nodiscard]] std::span<std::complex<double>> charges();
  /// The place of a node in it.
  [[nodiscard]] std::size_t place(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * size_[1] + j) * size_[2] + k;
  }
  /// Turns the charges into potentials.
  void transform();

 private:
  struct Destroy {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };
  using Plan = std::unique_ptr<fftw_plan_s, Destroy>;

  std::array<std::size_t, 3> size_ = {};  // with padding
  std::vector<std::complex<double>> values_;
  std::vector<std::complex<double>> spectrum_;  // of G, over the number of values
  Plan forward_, backward_;
};

}  // namespace idiophone::harmonic
