#include "side_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::bench {

namespace {

constexpr int pieces = 16;  // along each edge of a face

/// A piece of a side, and how the nodes around it share what is there.
struct SidePiece {
  std::array<double, 2> ends;      ///< m, along the side, ascending
  double area = 0.0;               ///< m2, as it is seen from the side
  std::span<const Index> nodes;    ///< of its face
  std::span<const double> shares;  ///< [nodes] shape functions in its middle; their sum is 1
};

using PieceVisit = std::function<void(const SidePiece&)>;

/// The ends along the side of a piece whose middle and whose half edges are given.
std::array<double, 2> ends_of(double middle, double first, double second) {
  const double half = std::abs(first) + std::abs(second);
  return {middle - half, middle + half};
}

/// A point of a quadrilateral face, the same in all elements.
struct FacePoint {
  std::vector<double> shares;  ///< [nodes of the face] shape functions
  Eigen::MatrixX2d slopes;     ///< [nodes of the face x 2] their derivatives by half edges of a piece
};

/// The middles of the pieces of a face.
std::vector<FacePoint> points_of(element::Type type, const element::Face& face) {
  const std::vector<Vector3>& places = element::reference(type).nodes;
  const Vector3 corner = places[face.nodes[0]];
  const Vector3 first = places[face.nodes[1]] - corner, second = places[face.nodes[3]] - corner;
  Eigen::Matrix<double, 3, 2> half_edges;
  half_edges << first / (2 * pieces), second / (2 * pieces);
  std::vector<FacePoint> points;
  for (int i = 0; i < pieces; ++i) {
    for (int j = 0; j < pieces; ++j) {
      const Vector3 xi = corner + (i + 0.5) / pieces * first + (j + 0.5) / pieces * second;
      const Eigen::VectorXd shares = element::shape_functions(type, xi);
      const Eigen::MatrixX2d slopes = element::shape_gradients(type, xi) * half_edges;
      points.push_back({{}, slopes(face.nodes, Eigen::all)});
      std::ranges::transform(face.nodes, std::back_inserter(points.back().shares),
                             [&](int node) { return shares[node]; });
    }
  }
  return points;
}

void visit_quadrilateral(const mesh::Mesh& mesh, std::span<const Index> nodes, const std::vector<FacePoint>& points,
                         const Side& side, const PieceVisit& visit) {
  Eigen::Matrix3Xd places(3, std::ssize(nodes));
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    places.col(k) = mesh.nodes[nodes[static_cast<std::size_t>(k)]];
  }
  for (const FacePoint& point : points) {
    const Eigen::Matrix<double, 3, 2> half_edges = places * point.slopes;
    const double middle = places.row(side.along).dot(Eigen::RowVectorXd::Map(point.shares.data(), places.cols()));
    const double area = 4 * std::abs(half_edges.col(0).cross(half_edges.col(1))[side.facing]);
    visit({ends_of(middle, half_edges(side.along, 0), half_edges(side.along, 1)), area, nodes, point.shares});
  }
}

/// The faces of hexahedra that have triangles of the side.
void visit_quadrilaterals(const mesh::Mesh& mesh, std::vector<mesh::Triangle> of_side, const Side& side,
                          const PieceVisit& visit) {
  std::ranges::for_each(of_side, mesh::turn_smallest_first);
  std::ranges::sort(of_side);
  const element::ReferenceElement& reference = element::reference(mesh.element);
  std::vector<std::vector<FacePoint>> points;  // [faces of an element]
  std::ranges::transform(reference.faces, std::back_inserter(points),
                         [&](const element::Face& face) { return points_of(mesh.element, face); });
  for_each_shared_face(mesh, [&](std::span<const mesh::ElementFace> shared) {
    const mesh::ElementFace& face = shared.front();
    std::vector<mesh::Triangle> triangles;
    mesh::append_triangles(mesh, face, triangles);
    if (shared.size() > 1 || !std::ranges::binary_search(of_side, triangles.front())) {
      return;
    }
    std::vector<Index> nodes;
    std::ranges::transform(reference.faces[face.side].nodes, std::back_inserter(nodes),
                           [&](int place) { return mesh.element_nodes(face.element)[place]; });
    visit_quadrilateral(mesh, nodes, points[face.side], side, visit);
  });
}

void visit_triangle(const mesh::Mesh& mesh, const mesh::Triangle& triangle, const Side& side, const PieceVisit& visit) {
  const Vector3 a = mesh.nodes[triangle[0]];
  const Vector3 first = mesh.nodes[triangle[1]] - a, second = mesh.nodes[triangle[2]] - a;
  const double area = std::abs(first.cross(second)[side.facing]) / (2.0 * pieces * pieces);
  const std::array<Index, 3> nodes = {triangle[0], triangle[1], triangle[2]};
  const auto add = [&](double b, double c) {
    const std::array<double, 3> shares = {1 - b - c, b, c};
    const double middle = (a + b * first + c * second)[side.along];
    constexpr double half = 0.25 / pieces;  // of an edge: the mean width of a triangle is half of its length
    const auto ends = ends_of(middle, half * first[side.along], half * second[side.along]);
    visit({ends, area, nodes, shares});
  };
  for (int i = 0; i < pieces; ++i) {
    for (int j = 0; i + j < pieces; ++j) {
      add((i + 1.0 / 3) / pieces, (j + 1.0 / 3) / pieces);
      if (i + j < pieces - 1) {
        add((i + 2.0 / 3) / pieces, (j + 2.0 / 3) / pieces);
      }
    }
  }
}

void for_each_piece(const mesh::Mesh& mesh, const std::vector<mesh::Triangle>& faces, const Side& side,
                    const PieceVisit& visit) {
  switch (mesh.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      for (const mesh::Triangle& triangle : faces) {
        visit_triangle(mesh, triangle, side, visit);
      }
      return;
    case element::Kind::hex:
      visit_quadrilaterals(mesh, faces, side, visit);
      return;
  }
  element::unknown_kind();
}

}  // namespace

SidePieces::SidePieces(const mesh::Mesh& mesh, const std::vector<mesh::Triangle>& faces, const Side& side) {
  const auto nodes = static_cast<Eigen::Index>(mesh.nodes.size());
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(nodes);
  std::vector<Eigen::Triplet<double>> areas_of_pieces;
  for_each_piece(mesh, faces, side, [&](const SidePiece& piece) {
    for (std::size_t k = 0; k < piece.nodes.size(); ++k) {
      const double area = piece.shares[k] * piece.area;
      areas_of_pieces.emplace_back(piece.nodes[k], static_cast<int>(ends_.size()), area);
      areas[piece.nodes[k]] += area;
    }
    ends_.push_back(piece.ends);
  });
  Eigen::SparseMatrix<double, Eigen::RowMajor> of_pieces(nodes, std::ssize(ends_));
  of_pieces.setFromTriplets(areas_of_pieces.begin(), areas_of_pieces.end());
  const Eigen::VectorXd inverse = (areas.array() > 0).select(areas.cwiseInverse(), 0.0);
  shares_ = inverse.asDiagonal() * of_pieces;
}

Eigen::VectorXd SidePieces::depths_of(const std::vector<Cut>& cuts) const {
  Eigen::VectorXd depths(std::ssize(ends_));
  std::ranges::transform(ends_, depths.begin(),
                         [&](const std::array<double, 2>& ends) { return mean_depth_of(cuts, ends); });
  return shares_ * depths;
}

}  // namespace idiophone::bench
