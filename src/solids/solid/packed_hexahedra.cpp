#include "idiophone/solids/solid/packed_hexahedra.hpp"

#include <Eigen/LU>

#include "hexahedron_kernels.hpp"
#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/solids/solid/inverted_element.hpp"

namespace idiophone::solid {

namespace {

using Eigen::Matrix3d;

/// Whether a Jacobian is another one, to round-off.
bool same(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).norm() <= 1e-10 * a.norm();
}

/// J[i][k] = dX_i/dxi_k at each quadrature point. A parallelepiped has the same bits at all its points, so it doesn't
/// matter which elements share its pack.
std::vector<Matrix3d> jacobians(element::Type type, std::span<const Index> nodes, std::span<const Vector3> reference) {
  const Eigen::MatrixXd& plane = element::lobatto(type.plane).derivative;
  const Eigen::MatrixXd& thickness = element::lobatto(type.thickness).derivative;
  const int n = type.plane + 1;
  const int m = type.thickness + 1;
  const auto at = [&](int i, int j, int k) -> const Vector3& { return reference[nodes[i + n * (j + n * k)]]; };
  std::vector<Matrix3d> all;
  for (int k = 0; k < m; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        Matrix3d jacobian = Matrix3d::Zero();
        for (int l = 0; l < n; ++l) {
          jacobian.col(0) += plane(i, l) * at(l, j, k);
          jacobian.col(1) += plane(j, l) * at(i, l, k);
        }
        for (int l = 0; l < m; ++l) {
          jacobian.col(2) += thickness(k, l) * at(i, j, l);
        }
        all.push_back(jacobian);
      }
    }
  }
  if (std::ranges::all_of(all, [&](const Matrix3d& jacobian) { return same(jacobian, all.front()); })) {
    all.assign(all.size(), Matrix3d(all.front()));
  }
  return all;
}

}  // namespace

PackedHexahedra::Derivative::Derivative(int order) {
  const Eigen::MatrixXd& derivative = element::lobatto(order).derivative;
  for (Eigen::Index i = 0; i <= order; ++i) {
    for (Eigen::Index j = 0; j <= order; ++j) {
      at[i][j] = transposed[j][i] = derivative(i, j);
    }
  }
}

PackedHexahedra::PackedHexahedra(const mesh::BodyPart& part, std::span<const Vector3> reference)
    : layout_(part),
      plane_(part.element.plane),
      thickness_(part.element.thickness),
      along_plane_(plane_),
      along_thickness_(thickness_) {
  const Eigen::VectorXd& plane = element::lobatto(plane_).weights;
  const Eigen::VectorXd& thickness = element::lobatto(thickness_).weights;
  for_each_point([&](int i, int j, int k, int /*point*/) { weight_.push_back(plane[i] * plane[j] * thickness[k]); });
  nodes_.resize(layout_.pack_count() * points());
  for (std::size_t number = 0; number < layout_.pack_count(); ++number) {
    add_pack(number, part, reference);
  }
}

void PackedHexahedra::add_pack(std::size_t number, const mesh::BodyPart& part, std::span<const Vector3> reference) {
  std::vector<Geometry> at_points(points());
  bool parallelepipeds = true;
  const auto filled = static_cast<std::size_t>(layout_.filled_lanes(number));
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t element = layout_.first_element(number) + std::min(lane, filled - 1);
    const auto nodes = std::span(part.elements).subspan(element * points(), points());
    const std::vector<Matrix3d> all = jacobians(part.element, nodes, reference);
    parallelepipeds = parallelepipeds && std::ranges::all_of(all, [&](const Matrix3d& j) { return j == all.front(); });
    for (std::size_t q = 0; q < points(); ++q) {
      const double determinant = all[q].determinant();
      if (!(determinant > 0)) {
        throw InvertedElement(part.element_ids[element], determinant);
      }
      const Matrix3d inverse = all[q].inverse();
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
          at_points[q].inverse_jacobian.at[k][i][lane] = inverse(k, i);
        }
      }
      at_points[q].determinant[lane] = lane < filled ? determinant : 0.0;
      nodes_[number * points() + q].at[lane] = nodes[q];
    }
  }
  packs_.push_back({geometry_.size(), parallelepipeds ? 0U : 1U});
  geometry_.insert(geometry_.end(), at_points.begin(), parallelepipeds ? at_points.begin() + 1 : at_points.end());
}

void PackedHexahedra::assemble(std::size_t pack, const Flux& flux, HeldForces* held, NodeForce* force) const {
  ForceLine lines[lanes][most_points + 1];
  const int n = plane_ + 1;
  const int m = thickness_ + 1;
  Pack before[3] = {};
  for_each_point([&](int i, int j, int k, int node) {
    Pack sum[3] = {};
    add_along_line(&flux.at[0][0], 3 * n * (j + n * k), 3, n, along_plane_.transposed[i], sum);
    add_along_line(&flux.at[0][1], 3 * (i + n * n * k), 3 * n, n, along_plane_.transposed[j], sum);
    add_along_line(&flux.at[0][2], 3 * (i + n * j), 3 * n * n, m, along_thickness_.transposed[k], sum);
    if (node % 2 == 1) {
      put_lines(before, sum, lines, static_cast<std::size_t>(node) - 1);
    }
    std::copy(sum, sum + 3, before);
  });
  if (points() % 2 == 1) {
    put_lines(before, before, lines, points() - 1);
  }
  scatter_lines(lines, points(), layout_.filled_lanes(pack), pack, held,
                [&](std::size_t a, int lane) -> NodeForce& { return force[nodes(pack)[a].at[lane]]; });
}

void PackedHexahedra::add_mass(double density, PackRange range, std::span<double> mass) const {
  for (std::size_t pack = range.begin; pack < range.end; ++pack) {
    for (int lane = 0; lane < layout_.filled_lanes(pack); ++lane) {
      for (std::size_t q = 0; q < points(); ++q) {
        mass[nodes(pack)[q].at[lane]] +=
            density * weight_[q] * geometry_[packs_[pack].geometry + q * packs_[pack].stride].determinant[lane];
      }
    }
  }
}

}  // namespace idiophone::solid
