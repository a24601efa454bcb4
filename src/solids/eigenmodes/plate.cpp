#include "idiophone/solids/eigenmodes/plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "clough_tocher.hpp"
#include "plane_problem.hpp"
#include "plate_supports.hpp"

namespace idiophone::eigenmodes {

namespace {

using Nodes = std::array<Index, 6>;

CloughTocher element_of(const PlateUnknowns& unknowns, const Nodes& nodes) {
  CloughTocher::Frame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    frame.corners[i] = unknowns.places[nodes[i]];
    frame.tangents[i] = unknowns.tangents[nodes[i]];
    frame.normals[i] = unknowns.tangents[nodes[3 + i]];
  }
  return CloughTocher(frame);
}

/// The unknowns of an element, in the order of CloughTocher.
std::array<Index, 12> numbers_of(const Nodes& nodes) {
  std::array<Index, 12> numbers = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t component = 0; component < 3; ++component) {
      numbers[3 * i + component] = static_cast<Index>(3 * nodes[i] + component);
    }
    numbers[9 + i] = 3 * nodes[3 + i];
  }
  return numbers;
}

/// Derivative of the deflection along a vector, at a corner of a triangle, times its length.
double slope_along(const PlateUnknowns& unknowns, const std::vector<double>& field, Index corner,
                   const Eigen::Vector2d& vector) {
  const Eigen::Vector2d& tangent = unknowns.tangents[corner];
  const double* values = &field[3 * static_cast<std::size_t>(corner)];
  return values[1] * tangent.dot(vector) + values[2] * (tangent[0] * vector[1] - tangent[1] * vector[0]);
}

/// Deflections at the nodes of the mesh: edges bend as cubics.
std::vector<double> deflections(const mesh::PlaneMesh& mesh, const PlateUnknowns& unknowns,
                                const std::vector<double>& field) {
  std::vector<double> shape(mesh.nodes.size());
  for (const Nodes& nodes : mesh.elements) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = nodes[i], to = nodes[(i + 1) % 3];
      const Eigen::Vector2d along = unknowns.places[to] - unknowns.places[from];
      shape[from] = field[3 * static_cast<std::size_t>(from)];
      shape[nodes[3 + i]] = 0.5 * (shape[from] + field[3 * static_cast<std::size_t>(to)]) +
                            (slope_along(unknowns, field, from, along) - slope_along(unknowns, field, to, along)) / 8;
    }
  }
  return shape;
}

/// Far below the lowest modes, (rad/s)^2.
double shift_of(const mesh::PlaneMesh& mesh, const Plate& plate) {
  const auto [left, right] = std::ranges::minmax(mesh.nodes, {}, [](const mesh::Point2& node) { return node[0]; });
  const auto [low, high] = std::ranges::minmax(mesh.nodes, {}, [](const mesh::Point2& node) { return node[1]; });
  const double extent = std::max(right[0] - left[0], high[1] - low[1]);
  return 0.01 * std::pow(std::numbers::pi / extent, 4) * plate.stiffness / plate.density;
}

}  // namespace

std::vector<PlaneMode> plate_modes(const mesh::PlaneRegion& region, const mesh::PlaneMesh& mesh, const Plate& plate,
                                   const WantedModes& wanted) {
  const PlateUnknowns unknowns = plate_unknowns(region, mesh, plate);
  PlaneProblem problem(unknowns.held);
  for (const Nodes& nodes : mesh.elements) {
    const CloughTocher element = element_of(unknowns, nodes);
    problem.add(numbers_of(nodes), plate.stiffness * element.bending(plate.poisson) + plate.tension * element.slopes(),
                plate.density * element.squares());
  }
  problem.assemble();
  const auto rigid = rigid_plate_motions(unknowns);
  std::vector<PlaneMode> modes;
  for (const Eigenpair& pair : wanted_eigenpairs(problem, "plate", rigid, wanted, shift_of(mesh, plate))) {
    std::vector<double> shape = deflections(mesh, unknowns, pair.vector);
    orient_shape(shape);
    modes.push_back({frequency_of(pair.value), std::move(shape)});
  }
  return modes;
}

}  // namespace idiophone::eigenmodes
