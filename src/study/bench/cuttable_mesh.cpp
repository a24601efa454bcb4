#include "idiophone/study/bench/cuttable_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "side_pieces.hpp"
#include "triangles_along.hpp"

namespace idiophone::bench {

namespace {

/// Where a line along the side's axis through a place meets a triangle.
struct Crossing {
  double ahead = 0.0;              ///< m from the place towards the side's end of the axis
  std::array<double, 3> shares{};  ///< of the corners
};

/// None where the line passes the triangle, or lies in its plane.
std::optional<Crossing> crossing_of(const Vector3& place, const std::array<Vector3, 3>& corners, const Side& side) {
  constexpr double nothing = 1e-6;  // of the triangle
  const int u = (side.facing + 1) % 3, v = (side.facing + 2) % 3;
  const auto area = [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  };
  const double whole = area(corners[0], corners[1], corners[2]);
  const double length = (corners[1] - corners[0]).norm() + (corners[2] - corners[0]).norm();
  if (std::abs(whole) < nothing * length * length) {
    return {};
  }
  Crossing crossing;
  double height = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    crossing.shares.at(k) = area(place, corners.at((k + 1) % 3), corners.at((k + 2) % 3)) / whole;
    if (crossing.shares.at(k) < -nothing) {
      return {};
    }
    height += crossing.shares.at(k) * corners.at(k)[side.facing];
  }
  crossing.ahead = side.sign * (height - place[side.facing]);
  return crossing;
}

std::array<Vector3, 3> corners_of(const mesh::Mesh& mesh, const mesh::Triangle& triangle) {
  return {mesh.nodes[triangle[0]], mesh.nodes[triangle[1]], mesh.nodes[triangle[2]]};
}

}  // namespace

CuttableMesh::CuttableMesh(mesh::Mesh mesh, const Side& side) : mesh_(std::move(mesh)), side_(side) {
  const std::vector<mesh::Triangle> faces = side_faces(mesh_, side);
  pieces_ = std::make_unique<const SidePieces>(mesh_, faces, side);
  const TrianglesAlong below(mesh_, faces, side_.along);
  const TrianglesAlong surface(mesh_, mesh_.outer_surface(), side_.along);
  for (Index node = 0; node < std::ssize(mesh_.nodes); ++node) {
    follow(node, below, surface);
  }
}

CuttableMesh::~CuttableMesh() = default;

double CuttableMesh::thinnest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Follower& follower : followers_) {
    least = std::min(least, follower.thickness);
  }
  return least;
}

void CuttableMesh::follow(Index node, const TrianglesAlong& faces, const TrianglesAlong& surface) {
  const Vector3& place = mesh_.nodes[node];
  const double nothing = 1e-9 * (1 + place.norm());
  std::optional<Crossing> below;
  mesh::Triangle face{};
  for (const mesh::Triangle& triangle : faces.at(place[side_.along])) {
    const auto found = crossing_of(place, corners_of(mesh_, triangle), side_);
    if (found && found->ahead > -nothing && (!below || found->ahead < below->ahead)) {
      below = found;
      face = triangle;
    }
  }
  if (!below) {
    return;
  }
  double above = 0.0;  // to the nearest surface behind it, m
  for (const mesh::Triangle& triangle : surface.at(place[side_.along])) {
    const auto found = crossing_of(place, corners_of(mesh_, triangle), side_);
    if (found && found->ahead < -nothing && (above == 0 || -found->ahead < above)) {
      above = -found->ahead;
    }
  }
  if (above > 0) {
    const double thickness = above + std::max(0.0, below->ahead);
    std::array<double, 3> shares = below->shares;
    for (double& share : shares) {
      share *= above / thickness;
    }
    followers_.push_back({node, face, shares, thickness});
  }
}

mesh::Mesh CuttableMesh::with(const std::vector<Cut>& cuts) const {
  mesh::Mesh result = mesh_;
  if (cuts.empty()) {
    return result;
  }
  result.hash.clear();
  const Eigen::VectorXd depths = pieces_->depths_of(cuts);
  for (const Follower& follower : followers_) {
    double depth = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      depth += follower.shares.at(k) * depths[follower.corners.at(k)];
    }
    if (depth > follower.thickness / 2) {
      throw OutsideOfModel(
          fmt::format("cuts at {} = {:.4g} m take {:.2g} m, more than half of the body's {:.2g} m there",
                      axis_name(side_), mesh_.nodes[follower.node][side_.along], depth, follower.thickness));
    }
    result.nodes[follower.node][side_.facing] -= side_.sign * depth;
  }
  return result;
}

}  // namespace idiophone::bench
