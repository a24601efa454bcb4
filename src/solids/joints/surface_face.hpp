#pragma once
// A face of an element as a curved surface x(s, t), by the element's shape functions. Its coordinates are those of the
// reference triangle (s, t >= 0, s + t <= 1) or of the unit square.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::joints {

/// Coordinates s, t of a point on a face.
using FacePlace = Eigen::Vector2d;

class SurfaceFace {
 public:
  /// @param first_node  global number of the first node of the mesh
  SurfaceFace(const mesh::Mesh& mesh, const mesh::ElementFace& face, Index first_node);

  /// What there is at one place of the face.
  struct Spot {
    Eigen::VectorXd values;                ///< [nodes] shape functions
    Eigen::MatrixX2d slopes;               ///< [nodes x 2] their derivatives along s and t
    Vector3 position;                      ///< m
    Eigen::Matrix<double, 3, 2> tangents;  ///< dx/ds, dx/dt, m

    /// Outward normal, as long as the area of a unit square of s and t, m2.
    [[nodiscard]] Vector3 normal() const;
  };
  [[nodiscard]] Spot at(const FacePlace& place) const;

  /// Where a straight line meets the face.
  struct Crossing {
    Spot spot;
    double distance;  ///< along the line, m
  };
  /// None where it passes the face or runs along it.
  /// @param direction  unit vector
  [[nodiscard]] std::optional<Crossing> crossing(const Vector3& start, const Vector3& direction) const;

  /// A place with its share of the integral over the face, the area of s and t.
  struct Point {
    FacePlace place;
    double weight;
  };
  /// The rule with so many points along s and t.
  [[nodiscard]] std::vector<Point> quadrature(int points) const;

  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }  ///< [nodes] global numbers
  [[nodiscard]] int order() const;                                          ///< the largest of its shape functions
  [[nodiscard]] const Vector3& centre() const { return centre_; }           ///< of a sphere around it, m
  [[nodiscard]] double radius() const { return radius_; }                   ///< of that sphere, m
  [[nodiscard]] double area() const { return area_; }                       ///< of its straight triangles, m2

 private:
  [[nodiscard]] bool is_triangle() const { return face_.corners.size() == 3; }
  [[nodiscard]] bool contains(const FacePlace& place) const;

  element::Type type_;
  const element::Face& face_;
  std::vector<Index> nodes_;
  std::vector<Vector3> positions_;  // [nodes] m
  Vector3 centre_ = Vector3::Zero();
  double radius_ = 0.0;
  double area_ = 0.0;
};

}  // namespace idiophone::joints
