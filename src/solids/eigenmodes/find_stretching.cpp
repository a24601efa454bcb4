#include "find_stretching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "idiophone/foundation/dense/dense.hpp"
#include "rigid_motions.hpp"
#include "static_stretch.hpp"

namespace idiophone::eigenmodes {

namespace {

/// Modal coordinates of random vibrations.
class RandomVibrations {
 public:
  explicit RandomVibrations(const std::vector<double>& frequencies) : frequencies_(frequencies) {}

  /// Of equal energy in all modes on average, [modes x count]; only their ratios mean something.
  [[nodiscard]] Eigen::MatrixXd draw(Eigen::Index count) {
    Eigen::MatrixXd places(std::ssize(frequencies_), count);
    for (Eigen::Index n = 0; n < count; ++n) {
      for (Eigen::Index mode = 0; mode < places.rows(); ++mode) {
        // std::uniform_real_distribution may differ between libraries.
        const double random = static_cast<double>(generator_()) / static_cast<double>(std::mt19937_64::max());
        places(mode, n) = (2 * random - 1) * frequencies_.front() / frequencies_[static_cast<std::size_t>(mode)];
      }
    }
    return places;
  }

 private:
  const std::vector<double>& frequencies_;
  std::mt19937_64 generator_;
};

/// Takes what an orthonormal basis contains from some vectors. Once is enough: of what joins the basis, a share is left
/// that is far above rounding.
void remove(const Eigen::Ref<const Eigen::MatrixXd>& basis, Eigen::Ref<Eigen::MatrixXd> vectors) {
  vectors -= basis * (basis.transpose() * vectors).eval();
}

/// [size of the space, strains] Orthonormal strains that hold all but a share of what random vibrations stretch.
/// @param shapes  [3 x nodes, modes]
Eigen::MatrixXd find_range(const StrainSpace& space, const StaticStretch& statics, const Eigen::MatrixXd& shapes,
                           const std::vector<double>& frequencies, double tolerance) {
  constexpr int enough = 8;             // draws that hold nothing new, one after another
  constexpr Eigen::Index at_once = 16;  // draws whose strains are computed together
  RandomVibrations vibrations(frequencies);
  Eigen::MatrixXd range(space.size(), 0);
  for (int passed = 0; passed < enough;) {
    const Eigen::MatrixXd strains = statics.remainders(space.quadratic(shapes * vibrations.draw(at_once)));
    Eigen::MatrixXd rests = strains;
    remove(range, rests);
    const Eigen::Index known = range.cols();
    range.conservativeResize(Eigen::NoChange, known + at_once);
    Eigen::Index found = known;
    for (Eigen::Index n = 0; n < at_once && passed < enough; ++n) {
      auto rest = rests.col(n);
      remove(range.middleCols(known, found - known), rest);
      if (rest.squaredNorm() <= tolerance * strains.col(n).squaredNorm()) {
        ++passed;
        continue;
      }
      passed = 0;
      range.col(found++) = rest.normalized();
    }
    range.conservativeResize(Eigen::NoChange, found);
  }
  return range;
}

/// [bodies][regions]
std::vector<std::vector<solid::StiffnessMatrix>> elasticities(const Operators& operators, std::size_t bodies) {
  std::vector<std::vector<solid::StiffnessMatrix>> found(bodies);
  for (std::size_t body = 0; body < bodies; ++body) {
    const solid::Solid& solid = operators.dynamics().solid(body);
    for (std::size_t region = 0; region < solid.region_count(); ++region) {
      found[body].push_back(stiffness_matrix(solid.elasticity(region)));
    }
  }
  return found;
}

/// What joints add to the stiffness of undeformed bodies.
std::vector<NodeSpring> springs(const joints::Joints& joints) {
  constexpr double rounding = 1e-12;  // of the largest eigenvalue
  std::vector<NodeSpring> found;
  for (std::size_t joint = 0; joint < joints.all().size(); ++joint) {
    joints.for_each_stiffness(joint, [&](std::span<const Index> nodes, const Eigen::MatrixXd& stiffness) {
      const auto [values, vectors] = dense::eigenpairs(stiffness);
      const auto kept = (values.array() > rounding * values.tail(1).value()).count();
      found.push_back({{nodes.begin(), nodes.end()},
                       values.tail(kept).cwiseSqrt().asDiagonal() * vectors.rightCols(kept).transpose()});
    });
  }
  return found;
}

/// Shapes without the rigid motions that only supports resist, [3 x nodes, modes]. Turning as a whole strains nothing,
/// but the second order of a linear field of rotation would.
Eigen::MatrixXd without_rigid_motions(const Eigen::MatrixXd& shapes, const Operators& operators, const mesh::Part& part,
                                      const std::vector<double>& node_masses) {
  const auto rigid = rigid_motions(part, operators, MPI_COMM_SELF, Resistance::groups);
  if (rigid.empty() || std::ranges::all_of(operators.support(), [](double stiffness) { return stiffness == 0.0; })) {
    return shapes;
  }
  const Eigen::Map<const Eigen::VectorXd> of_nodes(node_masses.data(), std::ssize(node_masses));
  const Eigen::VectorXd masses = of_nodes.transpose().replicate<3, 1>().reshaped();
  const Eigen::MatrixXd motions = orthonormal(rigid, masses);
  return shapes - motions * (motions.transpose() * (masses.asDiagonal() * shapes)).eval();
}

}  // namespace

modal_bodies::Stretching find_stretching(const Operators& operators, const mesh::Part& part,
                                         const modal_bodies::ModalBasis& basis, const ShiftedStiffness& stiffness,
                                         double tolerance) {
  if (operators.is_deformed()) {
    throw std::runtime_error(fmt::format("the prestress {}", deforms));
  }
  const StrainSpace space(part, elasticities(operators, part.bodies.size()), springs(operators.dynamics().joints()));
  const auto modes = std::ssize(basis.frequencies);
  const Eigen::Map<const Eigen::MatrixXd> all(basis.shapes.data(), std::ssize(basis.shapes) / modes, modes);
  const Eigen::MatrixXd shapes = without_rigid_motions(all, operators, part, basis.masses);
  const StaticStretch statics(stiffness, space, basis, rigid_motions(part, operators, MPI_COMM_SELF));
  const Eigen::MatrixXd range = find_range(space, statics, shapes, basis.frequencies, tolerance);

  modal_bodies::Stretching found;
  const Eigen::MatrixXd linear = space.linear(shapes).transpose() * range;
  found.linear.assign(linear.reshaped().begin(), linear.reshaped().end());
  for (const Eigen::MatrixXd& product : space.products(range, shapes)) {
    found.quadratic.insert(found.quadratic.end(), product.reshaped().begin(), product.reshaped().end());
  }
  const Eigen::MatrixXd rotation = space.rotations(shapes);
  found.rotation.assign(rotation.reshaped().begin(), rotation.reshaped().end());
  return found;
}

}  // namespace idiophone::eigenmodes
