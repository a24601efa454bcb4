#include "idiophone/solid/tangent_stiffness.hpp"

#include <Eigen/LU>

#include "idiophone/solid/elastic_law.hpp"
#include "idiophone/solid/elements.hpp"

namespace idiophone::solid {

namespace {

/// With g_a = grad N_a and f_i the rows of F:
/// K_(ai)(bj) = sum_q w [ delta_ij g_a S g_b + lambda (f_i g_a)(f_j g_b) + mu ((f_i f_j)(g_a g_b) + (f_i g_b)(f_j g_a))
/// ].
template <class Element>
Eigen::MatrixXd tangent(const ElasticLaw& law, std::span<const Vector3> reference,
                        std::span<const Vector3> displacement) {
  constexpr Eigen::Index n = Element::nodes;
  Eigen::Matrix<double, 3, n> x;
  Eigen::Matrix<double, 3, n> u;
  for (Eigen::Index a = 0; a < n; ++a) {
    x.col(a) = reference[static_cast<std::size_t>(a)];
    u.col(a) = displacement[static_cast<std::size_t>(a)];
  }
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (int q = 0; q < Element::points; ++q) {
    Eigen::Matrix<double, n, 3> slopes;
    for (Eigen::Index a = 0; a < n; ++a) {
      for (int k = 0; k < 3; ++k) {
        slopes(a, k) = Element::gradient(q, static_cast<int>(a), k);
      }
    }
    const Eigen::Matrix3d jacobian = x * slopes;
    const double weight = Element::weight * jacobian.determinant();
    const Eigen::Matrix<double, 3, n> g = (slopes * jacobian.inverse()).transpose();
    const Eigen::Matrix3d h = u * g.transpose();
    const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + h;
    const Eigen::Matrix3d strain = (h + h.transpose() + h.transpose() * h) / 2;
    const Eigen::Matrix3d s = law.lambda * strain.trace() * Eigen::Matrix3d::Identity() + 2 * law.mu * strain;
    const Eigen::Matrix<double, 3, n> fg = f * g;
    const Eigen::Matrix<double, n, n> geometric = g.transpose() * s * g;
    const Eigen::Matrix<double, n, n> gg = g.transpose() * g;
    const Eigen::Matrix3d ff = f * f.transpose();
    for (Eigen::Index a = 0; a < n; ++a) {
      for (Eigen::Index b = 0; b < n; ++b) {
        stiffness.block<3, 3>(3 * a, 3 * b) +=
            weight * (geometric(a, b) * Eigen::Matrix3d::Identity() + law.lambda * fg.col(a) * fg.col(b).transpose() +
                      law.mu * (ff * gg(a, b) + fg.col(b) * fg.col(a).transpose()));
      }
    }
  }
  return stiffness;
}

}  // namespace

Eigen::MatrixXd tangent_stiffness(mesh::ElementType type, const scene::Material& material,
                                  std::span<const Vector3> reference, std::span<const Vector3> displacement) {
  const ElasticLaw law(material);
  return type == mesh::ElementType::tet4 ? tangent<Tet4>(law, reference, displacement)
                                         : tangent<Tet10>(law, reference, displacement);
}

}  // namespace idiophone::solid
