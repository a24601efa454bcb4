#include "plate_supports.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::eigenmodes {

namespace {

using Eigen::Vector2d;

Vector2d place_of(const mesh::PlaneMesh& mesh, Index node) {
  return Vector2d::Map(mesh.nodes[node].data());
}

/// Puts the nodes of circles where the polygon through them has the area of the circle. Those of supported circles
/// stay: it is on the circle that they can't move.
void enlarge_circles(PlateUnknowns& unknowns, const std::vector<mesh::Contour>& contours, const mesh::PlaneMesh& mesh,
                     const Plate& plate) {
  std::vector<int> edges(contours.size(), 0);
  for (const mesh::RimEdge& edge : mesh.rim) {
    ++edges[edge.contour];
  }
  for (const mesh::RimEdge& edge : mesh.rim) {
    const mesh::Contour& contour = contours[edge.contour];
    if (!contour.is_circle() || plate.edges[edge.contour].front() == PlateEdge::supported) {
      continue;
    }
    const double angle = 2 * std::numbers::pi / edges[edge.contour];
    const auto centre = Vector2d::Map(contour.centre.data());
    for (const Index end : edge.ends) {
      unknowns.places[end] = centre + std::sqrt(angle / std::sin(angle)) * (place_of(mesh, end) - centre);
    }
  }
}

/// Unit vector along the contour at the end of an edge of its rim.
Vector2d tangent_at(Index node, const mesh::RimEdge& edge, const mesh::Contour& contour, const mesh::PlaneMesh& mesh) {
  if (contour.is_circle()) {
    const Vector2d outward = (place_of(mesh, node) - Vector2d::Map(contour.centre.data())).normalized();
    return {-outward[1], outward[0]};
  }
  const mesh::Segment side = mesh::side_of(contour, edge.side);
  return (side.to - side.from).normalized();
}

/// Holds the node at an end of a supported edge. At a corner between two supported sides it can't turn.
void support(PlateUnknowns& unknowns, Index node, const Vector2d& tangent) {
  constexpr double parallel = 1e-6;
  const std::size_t first = 3 * static_cast<std::size_t>(node);
  Vector2d& known = unknowns.tangents[node];
  if (!unknowns.held[first + 1]) {
    known = tangent;
  } else if (std::abs(known[0] * tangent[1] - known[1] * tangent[0]) > parallel) {
    unknowns.held[first + 2] = true;
  }
  unknowns.held[first] = unknowns.held[first + 1] = true;
}

void hold_edge(PlateUnknowns& unknowns, const mesh::RimEdge& edge, PlateEdge kind, const mesh::Contour& contour,
               const mesh::PlaneMesh& mesh) {
  if (kind == PlateEdge::free) {
    return;
  }
  for (const Index node : edge.ends) {
    support(unknowns, node, tangent_at(node, edge, contour, mesh));
    if (kind == PlateEdge::clamped) {
      unknowns.held[3 * static_cast<std::size_t>(node) + 2] = true;
    }
  }
  if (kind == PlateEdge::clamped) {
    unknowns.held[3 * static_cast<std::size_t>(edge.middle)] = true;
  }
}

/// What the motions 1, x/extent and y/extent, about the centre, are in an unknown.
Eigen::RowVector3d rigid_row(const PlateUnknowns& unknowns, std::size_t node, int component, const Vector2d& centre,
                             double extent) {
  const Vector2d& tangent = unknowns.tangents[node];
  if (!unknowns.is_corner[node]) {
    return {0, tangent[0] / extent, tangent[1] / extent};
  }
  switch (component) {
    case 0: {
      const Vector2d place = (unknowns.places[node] - centre) / extent;
      return {1, place[0], place[1]};
    }
    case 1:
      return {0, tangent[0] / extent, tangent[1] / extent};
    default:
      return {0, -tangent[1] / extent, tangent[0] / extent};
  }
}

}  // namespace

PlateUnknowns plate_unknowns(const mesh::PlaneRegion& region, const mesh::PlaneMesh& mesh, const Plate& plate) {
  const std::size_t nodes = mesh.nodes.size();
  PlateUnknowns unknowns{.places = std::vector<Vector2d>(nodes),
                         .tangents = std::vector<Vector2d>(nodes, Vector2d::UnitX()),
                         .is_corner = std::vector<bool>(nodes, false),
                         .held = std::vector<bool>(3 * nodes, false)};
  for (std::size_t node = 0; node < nodes; ++node) {
    unknowns.places[node] = place_of(mesh, static_cast<Index>(node));
  }
  const std::vector<mesh::Contour> contours = region.contours();
  enlarge_circles(unknowns, contours, mesh, plate);
  for (const auto& element : mesh.elements) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(element[i], element[(i + 1) % 3]);
      const Vector2d along = (unknowns.places[high] - unknowns.places[low]).normalized();
      const std::size_t middle = element[3 + i];
      unknowns.tangents[middle] = {-along[1], along[0]};
      unknowns.is_corner[element[i]] = true;
      unknowns.held[3 * middle + 1] = unknowns.held[3 * middle + 2] = true;
    }
  }
  for (const mesh::RimEdge& edge : mesh.rim) {
    hold_edge(unknowns, edge, plate.edges[edge.contour][edge.side], contours[edge.contour], mesh);
  }
  return unknowns;
}

std::vector<std::vector<double>> rigid_plate_motions(const PlateUnknowns& unknowns) {
  const std::size_t nodes = unknowns.places.size();
  Eigen::AlignedBox2d box;
  for (const Vector2d& place : unknowns.places) {
    box.extend(place);
  }
  const Vector2d centre = box.center();
  const double extent = box.sizes().maxCoeff();
  Eigen::MatrixXd rigid(3 * nodes, 3);
  Eigen::Matrix3d held = Eigen::Matrix3d::Zero();
  for (std::size_t node = 0; node < nodes; ++node) {
    for (int component = 0; component < 3; ++component) {
      const std::size_t unknown = 3 * node + component;
      const bool is_used = unknowns.is_corner[node] || component == 0;
      const Eigen::RowVector3d row = rigid_row(unknowns, node, component, centre, extent);
      rigid.row(static_cast<Eigen::Index>(unknown)) = row;
      if (unknowns.held[unknown] && is_used) {
        held += row.transpose() * row;
      }
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(held);
  constexpr double nothing = 1e-12;
  std::vector<std::vector<double>> motions;
  for (int i = 0; i < 3; ++i) {
    if (solver.eigenvalues()[i] <= nothing * std::max(1.0, held.trace())) {
      const Eigen::VectorXd motion = rigid * solver.eigenvectors().col(i);
      motions.emplace_back(motion.begin(), motion.end());
    }
  }
  return motions;
}

}  // namespace idiophone::eigenmodes
