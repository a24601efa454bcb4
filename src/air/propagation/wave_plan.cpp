#include "idiophone/air/propagation/wave_plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::propagation {

namespace {

/// Unbounded obstacles are heard as the floor is: by the lowest plane of the grid.
void require_floor(const scene::Acoustics& acoustics, const radiation::HalfSpace& space) {
  const auto& floor = acoustics.radiation.floor;
  const bool same = floor && space.normal[2] > 1.0 - 1e-9 && std::abs(floor->height(space.point)) < 1e-9;
  if (!same) {
    throw std::runtime_error(
        fmt::format("radiation: with model waves, an obstacle half_space must be horizontal and reflect sound; give "
                    "radiation: {{floor: {{at: [0, 0, {}]}}}} at the same height, or use a box as the obstacle",
                    space.point[2]));
  }
}

}  // namespace

waves::Plan wave_plan(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface,
                      MPI_Comm communicator) {
  waves::Wishes wishes{.cell = acoustics.radiation.grid.cell,
                       .margin = acoustics.radiation.grid.margin,
                       .speed = acoustics.radiation.air.speed,
                       .rate = acoustics.audio.rate,
                       .floor = {}};
  wishes.low.setConstant(std::numeric_limits<double>::max());
  wishes.high = -wishes.low;
  const auto enclose = [&](const Vector3& point) {
    wishes.low = wishes.low.cwiseMin(point);
    wishes.high = wishes.high.cwiseMax(point);
  };
  for (const Vector3& point : surface.reference) {
    enclose(point);
  }
  for (const auto& triangle : surface.obstacles) {
    for (const Vector3& point : triangle) {
      enclose(point);
    }
  }
  for (const radiation::HalfSpace& space : surface.half_spaces) {
    require_floor(acoustics, space);
  }
  if (const auto& floor = acoustics.radiation.floor) {
    wishes.floor = floor->at[2];
  }
  parallel::reduce(std::span(wishes.low.data(), 3), MPI_MIN, communicator);
  parallel::reduce(std::span(wishes.high.data(), 3), MPI_MAX, communicator);
  return waves::make_plan(wishes);
}

}  // namespace idiophone::propagation
