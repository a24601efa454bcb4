#include "space_spline.hpp"

#include <cmath>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::measured_maps {

namespace {

/// The functions that a spline is a sum of.
class SplineFunctions {
 public:
  explicit SplineFunctions(std::span<const Vector3> points) : points_(points.begin(), points.end()) {
    constexpr double least_reach = 0.1;
    for (const Vector3& point : points) {
      origin_ += point / static_cast<double>(points.size());
    }
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(3, 3);
    for (const Vector3& point : points) {
      spread += (point - origin_) * (point - origin_).transpose();
    }
    const auto [squares, axes] = dense::eigenpairs(spread);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (squares[axis] > 0.0 && squares[axis] >= least_reach * least_reach * squares[2]) {
        axes_.emplace_back(axes.col(axis));
      }
    }
    scale_ = squares[2] > 0.0 ? std::sqrt(squares[2] / static_cast<double>(points.size())) : 1.0;
  }

  [[nodiscard]] Eigen::Index points() const { return static_cast<Eigen::Index>(points_.size()); }

  /// Constant and linear functions.
  [[nodiscard]] Eigen::Index polynomials() const { return 1 + static_cast<Eigen::Index>(axes_.size()); }

  /// Values at a place, [points + polynomials].
  [[nodiscard]] Eigen::VectorXd at(const Vector3& place) const {
    Eigen::VectorXd values(points() + polynomials());
    Eigen::Index next = 0;
    for (const Vector3& point : points_) {
      values[next++] = std::pow((place - point).norm() / scale_, 3);
    }
    values[next++] = 1.0;
    for (const Vector3& axis : axes_) {
      values[next++] = axis.dot(place - origin_) / scale_;
    }
    return values;
  }

 private:
  std::vector<Vector3> points_;
  Vector3 origin_ = Vector3::Zero();
  std::vector<Vector3> axes_;  // of the linear functions
  double scale_ = 1.0;         // m, which keeps the numbers of one size
};

}  // namespace

Eigen::MatrixXd spline_weights(std::span<const Vector3> points, std::span<const Vector3> places) {
  const SplineFunctions functions(points);
  const Eigen::Index count = functions.points(), all = count + functions.polynomials();
  // Rows: the values at the points, then the conditions on the weights.
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::VectorXd values = functions.at(points[static_cast<std::size_t>(k)]);
    system.row(k) = values.transpose();
    system.col(k).tail(functions.polynomials()) = values.tail(functions.polynomials());
  }
  Eigen::MatrixXd coefficients(all, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    coefficients.col(k) = dense::least_squares(system, Eigen::VectorXd::Unit(all, k));
  }
  Eigen::MatrixXd weights(static_cast<Eigen::Index>(places.size()), count);
  for (std::size_t p = 0; p < places.size(); ++p) {
    weights.row(static_cast<Eigen::Index>(p)) = functions.at(places[p]).transpose() * coefficients;
  }
  return weights;
}

}  // namespace idiophone::measured_maps
