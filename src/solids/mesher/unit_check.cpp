#include "unit_check.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace idiophone::mesher {

namespace {

/// The sides of the box around all that is open, ascending, in the file's unit.
std::array<double, 3> box_sides() {
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities);
  if (entities.empty()) {
    return {};  // gmsh knows no box around nothing; the empty mesh is refused later
  }
  std::array<double, 3> low = {}, high = {};
  gmsh::model::getBoundingBox(-1, -1, low[0], low[1], low[2], high[0], high[1], high[2]);
  std::array<double, 3> sides = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  std::ranges::sort(sides);
  return sides;
}

}  // namespace

std::vector<mesh::Objection> doubts_about_unit(const mesh::MeshingRequest& request) {
  constexpr double most_tetrahedra = 1e9, most_quadrilaterals = 1e7;
  const auto size = request.parameters.find("size");
  if (size == request.parameters.end() || request.parameters.contains("scale")) {
    return {};
  }
  const auto [short_side, middle_side, long_side] = box_sides();
  const double squares = middle_side * long_side / (size->second * size->second);
  const double tetrahedra = 6.0 * std::numbers::sqrt2 * squares * short_side / size->second;  // regular ones
  const bool is_wall = request.dimension == 2;
  if (is_wall ? !(squares > most_quadrilaterals) : !(tetrahedra > most_tetrahedra)) {
    return {};
  }
  return {{"size",
           fmt::format("{} is {:.4g} x {:.4g} x {:.4g} m if its unit is the metre: with elements of {:g} m, a box of "
                       "this size has {:.1g} {}. Is the file in millimetres? Then give `parameters: {{scale: 0.001}}`; "
                       "if it is in metres, give `scale: 1` or a larger `size`",
                       request.file, long_side, middle_side, short_side, size->second, is_wall ? squares : tetrahedra,
                       is_wall ? "quadrilaterals" : "tetrahedra")}};
}

}  // namespace idiophone::mesher
