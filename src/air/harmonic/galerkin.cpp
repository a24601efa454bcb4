#include "galerkin.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::harmonic {

namespace {

/// Columns: the shape functions at the three corners of a piece of the outer panel.
using Piece = Eigen::Matrix3d;

/// Adds what one place of the outer panel contributes.
void add(PanelPair& pair, const Vector3& shape, double weight, const LayerPotentials& potentials) {
  for (std::size_t b = 0; b < 3; ++b) {
    pair.single_layer.col(b) += weight * potentials.single_layer.at(b) * shape;
    pair.double_layer.col(b) += weight * potentials.double_layer.at(b) * shape;
  }
}

void add_far(PanelPair& pair, const Panel& outer, const Panel& inner, double wave_number,
             std::span<const TrianglePoint> rule) {
  for (const TrianglePoint& q : rule) {
    add(pair, q.shape, q.weight * outer.area, quadrature_potentials(inner, outer.at(q.shape), wave_number, rule));
  }
}

/// A lower bound of the distance of a point from the inner panel, exact beside its face and its edges, m.
double distance_bound(const Panel& inner, const Vector3& point) {
  double beside = 0.0;
  for (std::size_t b = 0; b < 3; ++b) {
    const double shape = 1.0 + inner.gradients.at(b).dot(point - inner.corners.at(b));
    beside = std::max(beside, -shape / inner.gradients.at(b).norm());
  }
  return std::hypot(inner.normal.dot(point - inner.centre), beside);
}

/// Four pieces of half the size.
std::array<Piece, 4> cut(const Piece& piece) {
  const Vector3 a = piece.col(0), b = piece.col(1), c = piece.col(2);
  const Vector3 ab = (a + b) / 2.0, bc = (b + c) / 2.0, ca = (c + a) / 2.0;
  std::array<Piece, 4> pieces;
  pieces[0] << a, ab, ca;
  pieces[1] << ab, b, bc;
  pieces[2] << ca, bc, c;
  pieces[3] << ab, bc, ca;
  return pieces;
}

/// @param cuts  that are allowed
void add_near(PanelPair& pair, const Panel& outer, const Panel& inner, double wave_number, const Piece& piece,
              double radius, double area, int cuts) {
  const Vector3 centre = outer.at(piece.rowwise().mean());
  if (cuts > 0 && radius > distance_bound(inner, centre)) {
    for (const Piece& part : cut(piece)) {
      add_near(pair, outer, inner, wave_number, part, radius / 2.0, area / 4.0, cuts - 1);
    }
    return;
  }
  for (const TrianglePoint& q : triangle_rule_5()) {
    const Vector3 shape = piece * q.shape;
    add(pair, shape, q.weight * area, near_potentials(inner, outer.at(shape), wave_number));
  }
}

bool share_a_corner(const Panel& first, const Panel& second) {
  const double smallest = 1e-9 * first.radius;
  return std::ranges::any_of(first.corners, [&](const Vector3& a) {
    return std::ranges::any_of(second.corners, [&](const Vector3& b) { return (a - b).norm() < smallest; });
  });
}

/// The panel itself and its neighbours on a smooth surface need few cuts: on a plane the double layer vanishes.
int cuts_for(const Panel& outer, const Panel& inner) {
  constexpr double smooth = 0.7;
  return outer.normal.dot(inner.normal) > smooth && share_a_corner(outer, inner) ? 1 : 4;
}

}  // namespace

PanelPair panel_pair(const Panel& outer, const Panel& inner, double wave_number) {
  PanelPair pair;
  const double distance = (outer.centre - inner.centre).norm() / (outer.radius + inner.radius);
  if (distance > 3.0) {
    add_far(pair, outer, inner, wave_number, triangle_rule_2());
  } else if (distance > 1.0) {
    add_far(pair, outer, inner, wave_number, triangle_rule_5());
  } else {
    add_near(pair, outer, inner, wave_number, Piece::Identity(), outer.radius, outer.area, cuts_for(outer, inner));
  }
  return pair;
}

Eigen::Matrix3d panel_mass(const Panel& panel) {
  return panel.area / 12.0 * (Eigen::Matrix3d::Ones() + Eigen::Matrix3d::Identity());
}

}  // namespace idiophone::harmonic
