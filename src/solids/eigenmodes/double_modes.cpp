#include "double_modes.hpp"

#include <Eigen/SVD>
#include <algorithm>

namespace idiophone::eigenmodes {

namespace {

/// Whether two modes have one frequency, but for errors of the mesh and of the solver.
bool is_double(const Eigenpair& one, const Eigenpair& other) {
  constexpr double same = 2e-5;  // of squared frequencies
  return other.value - one.value < same * other.value;
}

/// That which the modes are aligned to.
std::size_t farthest_node(std::span<const Vector3> nodes) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& node : nodes) {
    middle += node / static_cast<double>(nodes.size());
  }
  double farthest = 0.0;
  for (const Vector3& node : nodes) {
    farthest = std::max(farthest, (node - middle).norm());
  }
  constexpr double rounding = 1e-6;
  const auto x_if_far = [&](const Vector3& node) {
    return (node - middle).norm() < (1 - rounding) * farthest ? -farthest : node[0] - middle[0];
  };
  return static_cast<std::size_t>(std::ranges::max_element(nodes, {}, x_if_far) - nodes.begin());
}

/// The right singular vectors of the two displacements there turn them so that they are perpendicular.
void align(Eigenpair& one, Eigenpair& other, std::size_t node) {
  Eigen::Matrix<double, 3, 2> moved;
  moved << Vector3(&one.vector[3 * node]), Vector3(&other.vector[3 * node]);
  const Eigen::Matrix2d turn = moved.jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV).matrixV();
  for (std::size_t c = 0; c < one.vector.size(); ++c) {
    const Eigen::RowVector2d mixed = Eigen::RowVector2d(one.vector[c], other.vector[c]) * turn;
    one.vector[c] = mixed[0];
    other.vector[c] = mixed[1];
  }
}

}  // namespace

void align_double_modes(std::span<Eigenpair> pairs, std::span<const Vector3> nodes) {
  const std::size_t node = farthest_node(nodes);
  for (std::size_t first = 0, last = 0; first < pairs.size(); first = last + 1) {
    for (last = first; last + 1 < pairs.size() && is_double(pairs[last], pairs[last + 1]); ++last) {
    }
    if (last == first + 1) {
      align(pairs[first], pairs[last], node);
    }
  }
}

}  // namespace idiophone::eigenmodes
