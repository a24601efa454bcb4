#pragma once
// The sums of FacingColumns for large surfaces, in a tree of clusters of triangles (Barnes and Hut, Nature 324, 1986).

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "facing_columns.hpp"

namespace idiophone::surface {

/// The work of a sum grows as the logarithm of the number of triangles. On the bodies of the test, the error is below
/// 1e-3 of the sum.
class FacingTree {
 public:
  /// @param surface  all triangles of a body, three corners each, m; each has an area
  explicit FacingTree(std::span<const std::array<Vector3, 3>> surface);

  /// As FacingColumns::sum() of all triangles, m.
  [[nodiscard]] double sum(const FlatPiece& one) const;

 private:
  /// Triangles that lie together and whose normals differ little.
  struct Cluster {
    std::size_t begin = 0, end = 0;  ///< its fours in the columns
    std::size_t after = 0;  ///< the next cluster that has none of its triangles; those up to there are its parts
    Vector3 centre = Vector3::Zero();                  ///< mean of the triangles' centres by area, m
    double radius = 0.0;                               ///< farthest centre from there, m
    Vector3 area = Vector3::Zero();                    ///< sum of areas times normals, m2
    Eigen::Matrix3d first = Eigen::Matrix3d::Zero();   ///< sum of (area normal)(x - centre)^T, m3
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< mean of (x - centre)(x - centre)^T by area, m2
    Vector3 axis = Vector3::Zero();                    ///< mean of the normals
    double sine = 0.0;      ///< of the largest angle between a normal and the axis; 1 beyond a right angle
    double doubtful = 0.0;  ///< area times this sine, m2: what may face the other way than the axis
  };

  /// A triangle's place in the surface; padding: none.
  using Order = std::vector<Index>;

  /// Appends the cluster of some fours, and its parts.
  void add_cluster(std::span<const FlatPiece> pieces, Order& order, std::size_t begin, std::size_t end);
  [[nodiscard]] static Cluster cluster_of(std::span<const FlatPiece> pieces, std::span<const Index> members);
  /// Whether far_sum() stands for the cluster.
  /// @param facing  cosine between the cluster's axis and the normal
  [[nodiscard]] bool is_far(const Cluster& cluster, double facing, double distance) const;
  [[nodiscard]] static double far_sum(const Cluster& cluster, const Vector3& normal, const Vector3& way,
                                      double distance);

  FacingColumns columns_;
  double size_ = 0.0;              ///< root of the whole area, m
  std::vector<Cluster> clusters_;  ///< each before its parts
};

}  // namespace idiophone::surface
