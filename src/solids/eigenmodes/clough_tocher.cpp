#include "clough_tocher.hpp"

#include <Eigen/LU>

namespace idiophone::eigenmodes {

namespace {

using Row12 = Eigen::Matrix<double, 1, 12>;
using Exponents = std::array<int, 3>;

/// Place of the Bernstein polynomial with these exponents among those of its degree.
int place_of(const Exponents& exponents) {
  const int rest = exponents[1] + exponents[2];
  return rest * (rest + 1) / 2 + exponents[2];
}

std::vector<Exponents> exponents_of(int degree) {
  std::vector<Exponents> all;
  for (int rest = 0; rest <= degree; ++rest) {
    for (int last = 0; last <= rest; ++last) {
      all.push_back({degree - rest, rest - last, last});
    }
  }
  return all;
}

double binomial(int n, int k) {
  return k == 0 ? 1.0 : binomial(n - 1, k - 1) * n / k;
}

/// Integrals of products of the Bernstein polynomials of a degree over a triangle of unit area (Farouki and Rajan
/// 1988).
Eigen::MatrixXd bernstein_products(int degree) {
  const std::vector<Exponents> all = exponents_of(degree);
  const auto count = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd products(count, count);
  for (const Exponents& a : all) {
    for (const Exponents& b : all) {
      double product = 2.0 / ((2 * degree + 1) * (2 * degree + 2) * binomial(2 * degree, degree));
      for (int i = 0; i < 3; ++i) {
        product *= binomial(a[i] + b[i], a[i]);
      }
      products(place_of(a), place_of(b)) = product;
    }
  }
  return products;
}

Row12 unit_row(int unknown) {
  return Row12::Unit(unknown);
}

/// The Bernstein coefficients of the three cubics (Farin 1986), each by the unknowns.
struct Net {
  std::array<Row12, 3> corner, forward, backward, spoke, inner, near;  ///< forward: towards the next corner
  Row12 top;                                                           ///< at the centroid
};

/// Of the edge from corner i to corner j: the coefficient that gives the middle of the edge its derivative.
Row12 inner_coefficient(const Net& net, const Eigen::Matrix2d& from_centre, const Eigen::Vector2d& normal, int i,
                        int j) {
  const Eigen::Vector2d along = from_centre.inverse() * normal;  // the normal by barycentric coordinates
  const double a = along[0], b = along[1], c = -a - b;
  const Row12 others = 0.25 * (a * net.corner[i] + b * net.forward[i] + c * net.spoke[i]) +
                       0.5 * (a * net.forward[i] + b * net.backward[j]) +
                       0.25 * (a * net.backward[j] + b * net.corner[j] + c * net.spoke[j]);
  return (unit_row(9 + i) / 3 - others) * (2 / c);
}

Net net_of(const CloughTocher::Frame& frame, const Eigen::Vector2d& centre) {
  Net net;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& corner = frame.corners[i];
    const Eigen::Vector2d& tangent = frame.tangents[i];
    const auto third_of_way_to = [&](const Eigen::Vector2d& place) -> Row12 {
      const Eigen::Vector2d third = (place - corner) / 3;
      return unit_row(3 * i) + third.dot(tangent) * unit_row(3 * i + 1) +
             (tangent[0] * third[1] - tangent[1] * third[0]) * unit_row(3 * i + 2);
    };
    net.corner[i] = unit_row(3 * i);
    net.forward[i] = third_of_way_to(frame.corners[(i + 1) % 3]);
    net.backward[i] = third_of_way_to(frame.corners[(i + 2) % 3]);
    net.spoke[i] = third_of_way_to(centre);
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    Eigen::Matrix2d from_centre;
    from_centre << frame.corners[i] - centre, frame.corners[j] - centre;
    net.inner[i] = inner_coefficient(net, from_centre, frame.normals[i], i, j);
  }
  for (int i = 0; i < 3; ++i) {  // slopes are continuous across the lines to the centroid
    net.near[i] = (net.inner[i] + net.inner[(i + 2) % 3] + net.spoke[i]) / 3;
  }
  net.top = (net.near[0] + net.near[1] + net.near[2]) / 3;
  return net;
}

/// Gradients of the barycentric coordinates of a triangle, 1/m. @param area  of it, m2
Eigen::Matrix<double, 3, 2> barycentric_gradients(const std::array<Eigen::Vector2d, 3>& corners, double area) {
  Eigen::Matrix<double, 3, 2> gradients;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d opposite = corners[(i + 2) % 3] - corners[(i + 1) % 3];
    gradients.row(i) << -opposite[1] / (2 * area), opposite[0] / (2 * area);
  }
  return gradients;
}

double area_of(const std::array<Eigen::Vector2d, 3>& corners) {
  const Eigen::Vector2d a = corners[1] - corners[0], b = corners[2] - corners[0];
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}

}  // namespace

CloughTocher::CloughTocher(const Frame& frame) {
  const Eigen::Vector2d centre = (frame.corners[0] + frame.corners[1] + frame.corners[2]) / 3;
  const Net net = net_of(frame, centre);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const std::array<Eigen::Vector2d, 3> corners = {frame.corners[i], frame.corners[j], centre};
    Part& part = parts_[i];
    part.area = area_of(corners);
    part.gradients = barycentric_gradients(corners, part.area);
    part.deflection.resize(10, 12);  // in the order of place_of()
    part.deflection << net.corner[i], net.forward[i], net.spoke[i], net.backward[j], net.inner[i], net.near[i],
        net.corner[j], net.spoke[j], net.near[j], net.top;
  }
}

CloughTocher::Coefficients CloughTocher::Part::derivative(int degree, const Coefficients& coefficients,
                                                          int axis) const {
  Coefficients derivative = Coefficients::Zero(degree * (degree + 1) / 2, 12);
  for (const Exponents& exponents : exponents_of(degree - 1)) {
    for (int i = 0; i < 3; ++i) {
      Exponents raised = exponents;
      ++raised[i];
      derivative.row(place_of(exponents)) += degree * gradients(i, axis) * coefficients.row(place_of(raised));
    }
  }
  return derivative;
}

CloughTocher::Matrix CloughTocher::Part::product(int degree, const Coefficients& a, const Coefficients& b) const {
  static const std::array<Eigen::MatrixXd, 4> products = {bernstein_products(0), bernstein_products(1),
                                                          bernstein_products(2), bernstein_products(3)};
  return area * a.transpose() * products[degree] * b;
}

CloughTocher::Matrix CloughTocher::bending(double poisson) const {
  Matrix sum = Matrix::Zero();
  for (const Part& part : parts_) {
    const Coefficients x = part.derivative(3, part.deflection, 0), y = part.derivative(3, part.deflection, 1);
    const Coefficients xx = part.derivative(2, x, 0), xy = part.derivative(2, x, 1), yy = part.derivative(2, y, 1);
    const Matrix mixed = part.product(1, xx, yy);
    sum += part.product(1, xx, xx) + part.product(1, yy, yy) + poisson * (mixed + mixed.transpose()) +
           2 * (1 - poisson) * part.product(1, xy, xy);
  }
  return sum;
}

CloughTocher::Matrix CloughTocher::slopes() const {
  Matrix sum = Matrix::Zero();
  for (const Part& part : parts_) {
    for (const int axis : {0, 1}) {
      const Coefficients slope = part.derivative(3, part.deflection, axis);
      sum += part.product(2, slope, slope);
    }
  }
  return sum;
}

CloughTocher::Matrix CloughTocher::squares() const {
  Matrix sum = Matrix::Zero();
  for (const Part& part : parts_) {
    sum += part.product(3, part.deflection, part.deflection);
  }
  return sum;
}

}  // namespace idiophone::eigenmodes
