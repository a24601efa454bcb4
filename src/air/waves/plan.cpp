#include "idiophone/air/waves/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/air/waves/wave_field.hpp"

namespace idiophone::waves {

namespace {

constexpr int least_layer = 10;           // cells
constexpr double least_thickness = 0.04;  // of the layer, m: thinner ones reflect low frequencies
constexpr int clearance = 3;              // cells between the surfaces and the enclosure
constexpr int to_layer = 2;               // cells between the enclosure and the layer
constexpr double most_cells = 4e9;

/// Surfaces of decks often lie at round coordinates. The grid is shifted by a part of a cell along each axis, so that
/// they do not lie in its planes, where sheets are least accurate.
const Vector3 shift(0.37, 0.41, 0.29);

}  // namespace

double Plan::cells() const {
  return static_cast<double>(grid.cells[0]) * grid.cells[1] * grid.cells[2];
}

double Plan::bytes() const {
  double per_cell = 2.0;  // pressure and rate
  for (std::size_t axis = 0; axis < 3; ++axis) {
    per_cell += 2.0 * (grid.layer_at(axis, 0) + grid.layer_at(axis, 1)) / grid.cells.at(axis);
  }
  return per_cell * sizeof(float) * cells();
}

Enclosure Plan::reach() const {
  Enclosure reach = enclosure;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reach.from.at(axis) += grid.layer_at(axis, 0) > 0 ? 2 : -1;  // what touches a floor reaches a little below it
    reach.to.at(axis) -= 2;
  }
  return reach;
}

int steps_in_sample(double speed, double cell, int rate) {
  return static_cast<int>(std::ceil(speed / (rate * cell) / WaveField::largest_courant));
}

double courant_of(double speed, double cell, int rate) {
  return speed / (rate * cell) / steps_in_sample(speed, cell, rate);
}

Plan make_plan(const Wishes& wishes) {
  Plan plan;
  Grid& grid = plan.grid;
  grid.cell = wishes.cell;
  grid.layer = std::max(least_layer, static_cast<int>(std::ceil(least_thickness / wishes.cell)));
  grid.rigid_below = wishes.floor.has_value();
  const double outside = grid.layer + to_layer + clearance;
  grid.corner = wishes.low - Vector3::Constant(wishes.margin) - wishes.cell * (Vector3::Constant(outside) + shift);
  grid.corner[2] = wishes.floor.value_or(grid.corner[2]);
  const Vector3 extent = (wishes.high + Vector3::Constant(wishes.margin) - grid.corner) / wishes.cell;
  if (!((extent + Vector3::Constant(outside)).prod() < most_cells)) {
    throw std::runtime_error(fmt::format(
        "radiation: waves in {:.3g} x {:.3g} x {:.3g} m of air need more than {:.0e} cells of {:.3g} m; use larger "
        "cells",
        extent[0] * wishes.cell, extent[1] * wishes.cell, extent[2] * wishes.cell, most_cells, wishes.cell));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int& count = grid.cells.at(axis);
    count = static_cast<int>(std::ceil(extent[static_cast<Eigen::Index>(axis)] + outside));
    if (axis == 0) {
      count = (count + Grid::row_multiple - 1) / Grid::row_multiple * Grid::row_multiple;
    }
    const bool wall = grid.layer_at(axis, 0) == 0;
    plan.enclosure.from.at(axis) = wall ? 0 : grid.layer + to_layer;
    plan.enclosure.to.at(axis) = count - grid.layer - to_layer;
  }
  plan.steps = steps_in_sample(wishes.speed, wishes.cell, wishes.rate);
  plan.courant = courant_of(wishes.speed, wishes.cell, wishes.rate);
  return plan;
}

}  // namespace idiophone::waves
