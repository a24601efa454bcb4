#include "rigid_motions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/joints/joints.hpp"

namespace idiophone::eigenmodes {

namespace {

using Motions = Eigen::Matrix<double, 3, 6>;

/// The smallest box around the body, m.
struct BoundingBox {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;

  BoundingBox(const mesh::Part& part, MPI_Comm communicator) {
    for (Index node = 0; node < part.owned_nodes; ++node) {
      low = low.min(part.reference[node].array());
      high = high.max(part.reference[node].array());
    }
    parallel::reduce(std::span(low.data(), 3), MPI_MIN, communicator);
    parallel::reduce(std::span(high.data(), 3), MPI_MAX, communicator);
  }
  [[nodiscard]] Vector3 centre() const { return (low + high) / 2; }
  [[nodiscard]] double longest_side() const { return (high - low).maxCoeff(); }
};

/// What the six rigid motions do at a node: three translations, three rotations about the centre, in units of the size.
Motions motions_at(const Vector3& place, const BoundingBox& box) {
  const Vector3 arm = (place - box.centre()) / box.longest_side();
  Motions motions;
  motions.leftCols<3>().setIdentity();
  for (int axis = 0; axis < 3; ++axis) {
    motions.col(3 + axis) = Vector3::Unit(axis).cross(arm);
  }
  return motions;
}

/// Calls visit(body, node) for each owned node.
template <class Visitor>
void for_each_owned(const mesh::Part& part, const Visitor& visit) {
  for (std::size_t body = 0; body < part.bodies.size(); ++body) {
    for (Index node = part.bodies[body].owned_begin; node < part.bodies[body].owned_end; ++node) {
      visit(static_cast<Eigen::Index>(body), node);
    }
  }
}

/// How much rigid motions of the bodies are resisted, each body's six by themselves.
struct Resisted {
  explicit Resisted(const mesh::Part& part)
      : squares(Eigen::MatrixXd::Zero(6 * std::ssize(part.bodies), 6 * std::ssize(part.bodies))) {}

  /// Over all ranks, as parts of the scale. Collective.
  [[nodiscard]] Eigen::MatrixXd as_parts(MPI_Comm communicator) {
    parallel::reduce(std::span(squares.data(), static_cast<std::size_t>(squares.size())), MPI_SUM, communicator);
    parallel::reduce(std::span(&scale, 1), MPI_SUM, communicator);
    return scale > 0 ? Eigen::MatrixXd(squares / scale) : squares;
  }

  Eigen::MatrixXd squares;  ///< [6 x bodies, 6 x bodies]
  double scale = 0.0;       ///< the trace, if no terms cancelled each other
};

/// Of what holds the bodies.
Eigen::MatrixXd of_groups(const mesh::Part& part, const Operators& operators, const BoundingBox& box,
                          bool supports_resist, MPI_Comm communicator) {
  Resisted resisted(part);
  for_each_owned(part, [&](Eigen::Index body, Index node) {
    const Motions motions = motions_at(part.reference[node], box);
    for (int i = 0; i < 3; ++i) {
      if (!operators.is_free(3 * node + i) || (supports_resist && operators.support()[node] > 0)) {
        resisted.squares.block<6, 6>(6 * body, 6 * body) += motions.row(i).transpose() * motions.row(i);
        resisted.scale += motions.row(i).squaredNorm();
      }
    }
  });
  return resisted.as_parts(communicator);
}

/// Global number of the first node of each body. Collective.
std::vector<Index> first_nodes(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<Index> first(part.bodies.size(), part.global_nodes);
  for_each_owned(part,
                 [&](Eigen::Index body, Index node) { first[body] = std::min(first[body], part.node_ids[node]); });
  parallel::reduce(std::span(first), MPI_MIN, communicator);
  return first;
}

/// Of one joint.
/// @param first_node  global numbers of the first node of each body
Eigen::MatrixXd of_joint(const joints::Joints& joints, std::size_t joint, const mesh::Part& part,
                         const BoundingBox& box, const std::vector<Index>& first_node, MPI_Comm communicator) {
  Resisted resisted(part);
  joints.for_each_stiffness(joint, [&](std::span<const Index> nodes, const Eigen::MatrixXd& stiffness) {
    if (nodes.front() >= part.owned_nodes) {
      return;  // another rank's
    }
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(stiffness.rows(), resisted.squares.cols());
    for (std::size_t place = 0; place < nodes.size(); ++place) {
      const Index node = nodes[place];
      const auto body = std::ranges::upper_bound(first_node, part.node_ids[node]) - first_node.begin() - 1;
      motions.block<3, 6>(3 * static_cast<Eigen::Index>(place), 6 * body) = motions_at(part.reference[node], box);
    }
    resisted.squares += motions.transpose() * (stiffness * motions);
    resisted.scale += motions.cwiseAbs().cwiseProduct(stiffness.cwiseAbs() * motions.cwiseAbs()).sum();
  });
  return resisted.as_parts(communicator);
}

}  // namespace

std::vector<std::vector<double>> rigid_motions(const mesh::Part& part, const Operators& operators,
                                               MPI_Comm communicator, Resistance resistance) {
  const BoundingBox box(part, communicator);
  Eigen::MatrixXd squares =
      of_groups(part, operators, box, resistance == Resistance::groups_and_supports, communicator);
  const joints::Joints& joints = operators.dynamics().joints();
  const std::vector<Index> first_node = first_nodes(part, communicator);
  for (std::size_t joint = 0; joint < joints.all().size(); ++joint) {
    squares += of_joint(joints, joint, part, box, first_node, communicator);
  }
  const auto [resistances, vectors] = dense::eigenpairs(squares);
  // A hinge is straight to 1e-6 of its length, so what resists a turn about it may be 1e-12 of what resists others.
  const double least = 1e-11 * static_cast<double>(1 + joints.all().size());
  std::vector<std::vector<double>> found;
  for (Eigen::Index k = 0; k < resistances.size() && resistances[k] <= least; ++k) {
    auto& motion = found.emplace_back();
    for_each_owned(part, [&](Eigen::Index body, Index node) {
      const Vector3 moved = motions_at(part.reference[node], box) * vectors.block<6, 1>(6 * body, k);
      motion.insert(motion.end(), moved.begin(), moved.end());
    });
  }
  return found;
}

double rough_frequency(const scene::Solids& solids, const mesh::Part& part, const motion::Dynamics& dynamics,
                       MPI_Comm communicator) {
  std::array<double, 3> sums = {};  // volume, m3; area, m2; volume times the speed of waves in a bar, m4/s
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    double density = 0.0;  // the mean of its materials, kg/m3
    double speed = 0.0;    // likewise, m/s
    const std::vector<scene::MaterialRegion> regions = solids.bodies[b].all_regions();
    for (const scene::MaterialRegion& region : regions) {
      const scene::Material& material = solids.materials[region.material];
      density += material.density / static_cast<double>(regions.size());
      speed += std::sqrt(material.young / material.density) / static_cast<double>(regions.size());
    }
    for (const double mass : dynamics.model(b).masses()) {
      sums[0] += mass / density;
      sums[2] += mass / density * speed;
    }
  }
  for (const mesh::Triangle& triangle : part.surface) {
    const auto corner = [&](std::size_t i) { return part.reference[part.vertices[triangle[i]]]; };
    sums[1] += (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  parallel::reduce(sums, MPI_SUM, communicator);
  const double side = BoundingBox(part, communicator).longest_side();
  return sums[2] * 2 / sums[1] / (side * side);
}

}  // namespace idiophone::eigenmodes
