#include <fmt/format.h>

#include <cmath>

#include "forms_of_modes.hpp"
#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::mode_kinds {

namespace {

constexpr Eigen::Index along_length = 24, along_width = 16;

/// The displacement along the thickness on a grid, by the nearest node: [along_length x along_width].
Eigen::MatrixXd heights_on_grid(const BodyForm& form, const LocalShape& shape) {
  Eigen::MatrixXd heights(along_length, along_width);
  const Eigen::Matrix2Xd places = shape.places.topRows<2>();
  for (Eigen::Index i = 0; i < along_length; ++i) {
    for (Eigen::Index k = 0; k < along_width; ++k) {
      const Eigen::Vector2d place(((static_cast<double>(i) + 0.5) / along_length - 0.5) * form.extents[0],
                                  ((static_cast<double>(k) + 0.5) / along_width - 0.5) * form.extents[1]);
      Eigen::Index nearest = 0;
      (places.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
      heights(i, k) = shape.displacements(2, nearest);
    }
  }
  return heights;
}

/// Nodal lines across both sides of a product of two functions.
std::string lines_of(const Eigen::VectorXd& along, const Eigen::VectorXd& across) {
  constexpr double share = 0.15;
  const auto changes = [](const Eigen::VectorXd& values) {
    return sign_changes({values.begin(), values.end()}, share);
  };
  return fmt::format("({}, {})", changes(along), changes(across));
}

}  // namespace

KindName kind_in_plate(const BodyForm& form, const LocalShape& shape) {
  constexpr double least_share = 0.5, second_product = 0.25;
  if (shape.displacements.row(2).squaredNorm() < least_share * shape.displacements.squaredNorm()) {
    return {.name = "in plane", .is_counted = true};
  }
  // The shape is nearly a product of two functions, or, of a square, a sum of two products.
  const Eigen::MatrixXd heights = heights_on_grid(form, shape);
  const auto [squares, across] = dense::eigenpairs(Eigen::MatrixXd(heights.transpose() * heights));
  const Eigen::Index last = squares.size() - 1;
  const auto product = [&](Eigen::Index which) { return lines_of(heights * across.col(which), across.col(which)); };
  std::string name = product(last);
  if (squares[last - 1] > second_product * squares[last] && product(last - 1) != name) {
    name += " + " + product(last - 1);
  }
  return {.name = name};
}

}  // namespace idiophone::mode_kinds
