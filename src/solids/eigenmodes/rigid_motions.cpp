#include "rigid_motions.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <span>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::eigenmodes {

namespace {

using Motions = Eigen::Matrix<double, 3, 6>;
using Gram = dense::Matrix6;

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

}  // namespace

std::vector<std::vector<double>> rigid_motions(const mesh::Part& part, const Operators& operators,
                                               MPI_Comm communicator, Resistance resistance) {
  const BoundingBox box(part, communicator);
  const bool supports_resist = resistance == Resistance::groups_and_supports;
  const std::size_t nodes = part.owned_nodes;
  Gram squares = Gram::Zero();
  for (std::size_t node = 0; node < nodes; ++node) {
    const Motions motions = motions_at(part.reference[node], box);
    for (int i = 0; i < 3; ++i) {
      if (!operators.is_free(3 * node + i) || (supports_resist && operators.support()[node] > 0)) {
        squares += motions.row(i).transpose() * motions.row(i);
      }
    }
  }
  parallel::reduce(std::span(squares.data(), squares.size()), MPI_SUM, communicator);
  const auto [resistances, vectors] = dense::eigenpairs(squares);
  // A hinge is straight to 1e-6 of its length, so what resists a turn about it may be 1e-12 of what resists others.
  const double least = 1e-11 * squares.trace();
  std::vector<std::vector<double>> found;
  for (int k = 0; k < 6 && resistances[k] <= least; ++k) {
    auto& motion = found.emplace_back();
    for (std::size_t node = 0; node < nodes; ++node) {
      const Vector3 moved = motions_at(part.reference[node], box) * vectors.col(k);
      motion.insert(motion.end(), moved.begin(), moved.end());
    }
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
