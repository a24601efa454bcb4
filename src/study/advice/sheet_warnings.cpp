// What `check` and `run` say about sheets in the outermost eighth of a cell.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "idiophone/air/propagation/wave_plan.hpp"
#include "idiophone/run/bodies/prepared_surface.hpp"
#include "idiophone/study/advice/sheet_places.hpp"

namespace idiophone::advice {

namespace {

constexpr double good_clearance = 0.25;  // cells: nothing is gained by more

/// Whether it flies, falls or turns, so that it lies anywhere in a cell.
bool leaves_its_place(const scene::Body& body, const scene::Scene& scene) {
  const bool is_held = !body.fixed.empty() || !body.driven.empty() || !body.supports.empty();
  return !body.velocity.isZero() || !body.spin.isZero() || (!scene.gravity.isZero() && !is_held);
}

/// Of the sheet that lies worst; more than good_clearance counts as this.
double least_of(const std::vector<Sheet>& sheets, const waves::Grid& grid) {
  double least = good_clearance;
  for (const Sheet& sheet : sheets) {
    least = std::min(least, clearance(sheet, grid));
  }
  return least;
}

/// With the grid of a scene; negative where there is no such grid, because it has too many cells. Collective.
double least_with(const scene::Scene& scene, const std::vector<Sheet>& sheets,
                  const propagation::AudibleSurface& surface, MPI_Comm communicator) {
  try {
    return least_of(sheets, propagation::wave_plan(scene, surface, communicator).grid);
  } catch (const std::runtime_error&) {  // the same on all ranks
    return -1.0;
  }
}

/// What users read of a number.
double as_printed(double value) {
  return std::stod(fmt::format("{:.4g}", value));
}

/// What to do so that all sheets lie well. Collective.
std::string remedy(scene::Scene scene, const std::vector<Sheet>& sheets, const propagation::AudibleSurface& surface,
                   MPI_Comm communicator) {
  constexpr int divisions = 16;  // of a cell, that the margin grows by; then a cell grows by so many of its parts
  std::string best;
  double largest = least_clearance;
  scene::WaveGrid& grid = scene.radiation.grid;
  const auto try_it = [&](double& value, double wanted, const char* key) {
    const double before = std::exchange(value, as_printed(wanted));
    const double least = least_with(scene, sheets, surface, communicator);
    if (least > largest) {
      largest = least;
      best = fmt::format("radiation.{}: {:.4g} moves it inwards", key, value);
    }
    value = before;
  };
  for (int part = 1; part < divisions; ++part) {
    try_it(grid.margin, grid.margin + grid.cell * part / divisions, "margin");
  }
  for (int part = 1; best.empty() && part < divisions; ++part) {
    try_it(grid.cell, grid.cell * (1 + 0.5 * part / divisions), "cell");
  }
  return best.empty() ? "no margin and no cell that was tried moves all sheets inwards: move the body" : best;
}

}  // namespace

std::vector<std::optional<std::string>> sheet_warnings(const bodies::Preparation& ready, MPI_Comm communicator) {
  std::vector<std::optional<std::string>> warnings(ready.scene.bodies.size());
  const bool is_grid_known = ready.scene.recorded_bodies.empty();  // it reaches around recorded bodies, too
  if (ready.scene.radiation.model != scene::RadiationModel::waves || !is_grid_known) {
    return warnings;
  }
  const propagation::AudibleSurface surface = bodies::audible_surface(ready, communicator);
  std::vector<Sheet> sheets = sheets_along_planes(surface, ready.scene.radiation.grid.cell, communicator);
  std::erase_if(sheets,
                [&](const Sheet& sheet) { return leaves_its_place(ready.scene.bodies[sheet.body], ready.scene); });
  const waves::Grid grid = propagation::wave_plan(ready.scene, surface, communicator).grid;
  if (least_of(sheets, grid) >= least_clearance) {
    return warnings;
  }
  const std::string what_helps = remedy(ready.scene, sheets, surface, communicator);
  std::ranges::sort(sheets, std::ranges::greater(), [&](const Sheet& sheet) { return clearance(sheet, grid); });
  for (const Sheet& sheet : sheets) {  // the worst one of a body is the last
    if (clearance(sheet, grid) < least_clearance) {
      warnings[sheet.body] = fmt::format(
          "body {}: its sheet at {} = {:.6g} m lies in the outermost eighth of a cell of the air: its level can be "
          "half a decibel too high, and pitches that the air lowers can be 50 cents too high; {} "
          "(docs/use/waves.md#sheets)",
          ready.scene.bodies[sheet.body].name, "xyz"[sheet.axis], sheet.middle, what_helps);
    }
  }
  return warnings;
}

void print(const std::vector<std::optional<std::string>>& sheet_warnings) {
  for (const auto& warning : sheet_warnings) {
    if (warning) {
      spdlog::warn(*warning);
    }
  }
}

}  // namespace idiophone::advice
