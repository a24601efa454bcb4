#pragma once
// Hsieh, Clough and Tocher's triangle for thin plates (Clough and Tocher 1965): a cubic in each of three parts, which
// meet at the centroid, with continuous slopes inside the triangle and across its edges.

#include <Eigen/Core>
#include <array>

namespace idiophone::eigenmodes {

/// Twelve unknowns: at each corner the deflection and its derivatives along the tangent and across it, then the
/// derivatives across edges 01, 12 and 20 at their middles.
class CloughTocher {
 public:
  using Matrix = Eigen::Matrix<double, 12, 12>;

  struct Frame {
    std::array<Eigen::Vector2d, 3> corners;  ///< counter-clockwise, m
    std::array<Eigen::Vector2d, 3>
        tangents;  ///< [corners] unit vectors; the other derivative is along their left normal
    std::array<Eigen::Vector2d, 3> normals;  ///< [edges 01, 12, 20] unit vectors across them, either way
  };

  explicit CloughTocher(const Frame& frame);

  /// Twice the bending energy of a plate of unit stiffness D: integral of
  /// (w_xx + w_yy)^2 - 2 (1 - nu) (w_xx w_yy - w_xy^2).
  [[nodiscard]] Matrix bending(double poisson) const;
  [[nodiscard]] Matrix slopes() const;   ///< integral of w_x^2 + w_y^2
  [[nodiscard]] Matrix squares() const;  ///< integral of w^2

 private:
  /// Bernstein coefficients, a row each, by the unknowns.
  using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 12, 0, 10, 12>;

  /// One of the three parts: an edge and the centroid.
  struct Part {
    double area = 0.0;                      ///< m2
    Eigen::Matrix<double, 3, 2> gradients;  ///< of the barycentric coordinates, 1/m
    Coefficients deflection;                ///< [10]

    /// Coefficients of a derivative, whose degree is lower by one. @param axis  0: x, 1: y
    [[nodiscard]] Coefficients derivative(int degree, const Coefficients& coefficients, int axis) const;
    /// Integral of the product of two polynomials of that degree.
    [[nodiscard]] Matrix product(int degree, const Coefficients& a, const Coefficients& b) const;
  };

  std::array<Part, 3> parts_;
};

}  // namespace idiophone::eigenmodes
