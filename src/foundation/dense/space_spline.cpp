#include "idiophone/foundation/dense/space_spline.hpp"

#include <cmath>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::dense {

/// The functions that a spline is a sum of.
class SpaceSpline::Functions {
 public:
  explicit Functions(std::span<const Vector3> points) : points_(points.begin(), points.end()) {
    constexpr double least_reach = 0.1;
    for (const Vector3& point : points) {
      origin_ += point / static_cast<double>(points.size());
    }
    Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(3, 3);
    for (const Vector3& point : points) {
      spread += (point - origin_) * (point - origin_).transpose();
    }
    const auto [squares, axes] = eigenpairs(spread);
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

namespace {

/// The equations of the coefficients. Rows: the values at the points, then the conditions on the weights.
Eigen::MatrixXd spline_equations(const SpaceSpline::Functions& functions, std::span<const Vector3> points) {
  const Eigen::Index all = functions.points() + functions.polynomials();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index k = 0; k < functions.points(); ++k) {
    const Eigen::VectorXd values = functions.at(points[static_cast<std::size_t>(k)]);
    system.row(k) = values.transpose();
    system.col(k).tail(functions.polynomials()) = values.tail(functions.polynomials());
  }
  return system;
}

}  // namespace

SpaceSpline::SpaceSpline(std::span<const Vector3> points, std::span<const double> values)
    : functions_(std::make_shared<Functions>(points)) {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(functions_->points() + functions_->polynomials());
  right.head(functions_->points()) = Eigen::Map<const Eigen::VectorXd>(values.data(), functions_->points());
  coefficients_ = least_squares(spline_equations(*functions_, points), right);
}

double SpaceSpline::operator()(const Vector3& place) const {
  return functions_->at(place).dot(coefficients_);
}

Eigen::MatrixXd spline_weights(std::span<const Vector3> points, std::span<const Vector3> places) {
  const SpaceSpline::Functions functions(points);
  const Eigen::MatrixXd system = spline_equations(functions, points);
  Eigen::MatrixXd coefficients(system.rows(), functions.points());
  for (Eigen::Index k = 0; k < functions.points(); ++k) {
    coefficients.col(k) = least_squares(system, Eigen::VectorXd::Unit(system.rows(), k));
  }
  Eigen::MatrixXd weights(static_cast<Eigen::Index>(places.size()), functions.points());
  for (std::size_t p = 0; p < places.size(); ++p) {
    weights.row(static_cast<Eigen::Index>(p)) = functions.at(places[p]).transpose() * coefficients;
  }
  return weights;
}

}  // namespace idiophone::dense
