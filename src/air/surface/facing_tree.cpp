#include "facing_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::surface {

namespace {

constexpr std::size_t leaf_fours = 8;  ///< at most, of a cluster without parts
constexpr Index padding = -1;

/// One of the six directions along the axes: the nearest to a normal. Both sides of a sheet lie together in space.
int nearest_direction(const Vector3& area) {
  Eigen::Index axis = 0;
  area.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<int>(axis) + (area[axis] < 0 ? 1 : 0);
}

/// Triangles sorted by the directions; each direction begins a new four.
std::vector<Index> by_direction(std::span<const FlatPiece> pieces, std::vector<std::size_t>& begins) {
  std::array<std::vector<Index>, 6> lists;
  for (std::size_t number = 0; number < pieces.size(); ++number) {
    lists[nearest_direction(pieces[number].area)].push_back(static_cast<Index>(number));
  }
  std::vector<Index> order;
  for (std::vector<Index>& list : lists) {
    begins.push_back(order.size() / lane_count);
    order.insert(order.end(), list.begin(), list.end());
    order.resize((order.size() + lane_count - 1) / lane_count * lane_count, padding);
    list = {};
  }
  begins.push_back(order.size() / lane_count);
  return order;
}

/// The axis along which places differ most.
Eigen::Index longest_axis(std::span<const FlatPiece> pieces, std::span<const Index> members) {
  Eigen::AlignedBox3d box;
  for (const Index member : members) {
    box.extend(pieces[member].centre);
  }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  return axis;
}

/// Without the padding at the end.
std::span<Index> members_of(std::vector<Index>& order, std::size_t begin, std::size_t end) {
  const auto fours = std::span(order).subspan(begin * lane_count, (end - begin) * lane_count);
  return fours.first(std::ranges::find(fours, padding) - fours.begin());
}

}  // namespace

FacingTree::FacingTree(std::span<const std::array<Vector3, 3>> surface) : columns_(0) {
  std::vector<FlatPiece> pieces;
  pieces.reserve(surface.size());
  for (const std::array<Vector3, 3>& triangle : surface) {
    size_ += pieces.emplace_back(flat_piece(triangle)).area.norm();
  }
  size_ = std::sqrt(size_);
  std::vector<std::size_t> begins;
  Order order = by_direction(pieces, begins);
  for (std::size_t direction = 0; direction + 1 < begins.size(); ++direction) {
    if (begins[direction] < begins[direction + 1]) {
      add_cluster(pieces, order, begins[direction], begins[direction + 1]);
    }
  }
  columns_ = FacingColumns(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    if (order[place] != padding) {
      columns_.put(place, pieces[order[place]]);
    }
  }
}

void FacingTree::add_cluster(std::span<const FlatPiece> pieces, Order& order, std::size_t begin, std::size_t end) {
  const std::span<Index> members = members_of(order, begin, end);
  const std::size_t number = clusters_.size();
  clusters_.push_back(cluster_of(pieces, members));
  clusters_[number].begin = begin;
  clusters_[number].end = end;
  if (end - begin > leaf_fours) {
    const std::size_t middle = begin + (end - begin) / 2;
    const Eigen::Index axis = longest_axis(pieces, members);
    const auto place = [&](Index member) { return std::pair(pieces[member].centre[axis], member); };
    std::ranges::nth_element(members, members.begin() + (middle - begin) * lane_count, {}, place);
    add_cluster(pieces, order, begin, middle);
    add_cluster(pieces, order, middle, end);
  }
  clusters_[number].after = clusters_.size();
}

FacingTree::Cluster FacingTree::cluster_of(std::span<const FlatPiece> pieces, std::span<const Index> members) {
  Cluster cluster;
  double area = 0.0;
  for (const Index member : members) {
    const double share = pieces[member].area.norm();
    area += share;
    cluster.area += pieces[member].area;
    cluster.centre += share * pieces[member].centre;
  }
  cluster.centre /= area;
  cluster.axis = cluster.area.normalized();
  double cosine = 1.0;
  for (const Index member : members) {
    const Vector3 way = pieces[member].centre - cluster.centre;
    const double share = pieces[member].area.norm();
    cluster.radius = std::max(cluster.radius, way.norm());
    cluster.first += pieces[member].area * way.transpose();
    cluster.second += share / area * way * way.transpose();
    cosine = std::min(cosine, cluster.axis.dot(pieces[member].area) / share);
  }
  cluster.sine = cosine < 0 ? 1.0 : std::sqrt(std::max(0.0, 1.0 - cosine * cosine));  // 1: may face any way
  cluster.doubtful = area * cluster.sine;
  return cluster;
}

bool FacingTree::is_far(const Cluster& cluster, double facing, double distance) const {
  constexpr double opening = 0.3;  // radius over distance
  constexpr double small = 1e-5;   // of the sum about a compact body
  return cluster.radius < opening * distance && (facing >= cluster.sine || cluster.doubtful < small * size_ * distance);
}

double FacingTree::far_sum(const Cluster& cluster, const Vector3& normal, const Vector3& way, double distance) {
  const double square = distance * distance;
  const double facing = cluster.area.dot(normal);
  const double first = normal.dot(cluster.first * way);
  const double second = 3.0 * way.dot(cluster.second * way) / square - cluster.second.trace();
  return std::max(0.0, facing * (1.0 + second / (2.0 * square)) - first / square) / distance;
}

double FacingTree::sum(const FlatPiece& one) const {
  const Vector3 normal = one.area.normalized();
  double sum = 0.0;
  for (std::size_t number = 0; number < clusters_.size();) {
    const Cluster& cluster = clusters_[number];
    const double facing = cluster.axis.dot(normal);
    if (facing <= -cluster.sine) {  // all look away
      number = cluster.after;
      continue;
    }
    const Vector3 way = cluster.centre - one.centre;
    const double distance = way.norm();
    if (is_far(cluster, facing, distance)) {
      sum += far_sum(cluster, normal, way, distance);
      number = cluster.after;
    } else if (cluster.after == number + 1) {
      sum += columns_.sum(one, cluster.begin, cluster.end);
      number = cluster.after;
    } else {
      ++number;
    }
  }
  return sum;
}

}  // namespace idiophone::surface
