#include "idiophone/air/surface/emitter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "idiophone/air/surface/corners.hpp"

namespace idiophone::surface {

Emitter::Emitter(const std::vector<std::array<Index, 3>>& triangles, double dc_loss, SurfacePressure surface_pressure,
                 double fade_step)
    : triangles_(triangles.size()),
      dc_loss_(dc_loss),
      corners_(corner_places(triangles)),
      low_passed_(padded(triangles_)),
      without_constant_(padded(triangles_)),
      surface_pressure_(std::move(surface_pressure)),
      fade_step_(fade_step),
      fades_(fade_step > 0.0 ? triangles_ : 0) {
  if (!(dc_loss >= 0.0 && dc_loss < 1.0)) {
    throw std::invalid_argument(fmt::format("emitter: dc_loss is {}; it has to be at least 0 and below 1", dc_loss));
  }
}

void Emitter::start(const SurfaceMotion& motion) {
  low_passed_ = motion.pressure;
  without_constant_ = motion.pressure;
  if (dc_loss_ > 0) {
    std::ranges::fill(without_constant_, 0.0);
  }
  surface_pressure_.start(without_constant_);
}

void Emitter::emit(const SurfaceMotion& motion, Emission& emission) {
  emission.resize(padded(triangles_));
  if (!motion.radii.empty()) {
    surface_pressure_.set_radii(motion.radii);
  }
  block_constant(motion.pressure, emission.pressure);
  surface_pressure_.step(without_constant_, emission.pressure, emission.surface_pressure);
  low_passed_ = motion.pressure;
  without_constant_ = emission.pressure;
  emit_geometry(motion.position, emission);
  fade(emission);
}

void Emitter::fade(Emission& emission) {
  for (std::size_t i = 0; i < fades_.size(); ++i) {
    auto& [progress, area, normal] = fades_[i];
    const bool is_point = emission.area[i] == 0.0;
    const double target = is_point ? 0.0 : 1.0;
    progress = std::isnan(progress) ? target : std::clamp(progress + (is_point ? -fade_step_ : fade_step_), 0.0, 1.0);
    area = is_point ? area : emission.area[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& component = normal[static_cast<Eigen::Index>(axis)];
      component = is_point ? component : emission.normal[axis][i];
      emission.normal[axis][i] = component;
    }
    emission.area[i] = area * progress * progress * (3.0 - 2.0 * progress);  // those of two triangles add up to 1
  }
}

void Emitter::block_constant(const std::vector<double>& low_passed, std::vector<double>& pressure) const {
  for (std::size_t number = 0; number < pressure.size(); number += wide_count) {
    const WideLanes kept = (1.0 - dc_loss_) * load<WideLanes>(&without_constant_[number]);
    const WideLanes changed = load<WideLanes>(&low_passed[number]) - load<WideLanes>(&low_passed_[number]);
    put(kept + changed, &pressure[number]);
  }
}

void Emitter::emit_geometry(const std::vector<double>& positions, Emission& emission) const {
  for (std::size_t first = 0; first < padded(triangles_); first += lane_count) {
    const Corners corners = gather(&corners_[3 * first], positions.data());
    const VectorLanes twice_area = cross(corners.edge12, corners.edge13);
    const Lanes4 reciprocal = 1.0 / divisible_length(twice_area);
    put(0.5 * dot(twice_area, twice_area) * reciprocal, &emission.area[first]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(twice_area[axis] * reciprocal, &emission.normal[axis][first]);
      put(corners.sum[axis] * (1.0 / 3.0), &emission.centre[axis][first]);
    }
  }
}

void Emitter::archive(parallel::Archive& archive, const parallel::Rows& triangles) {
  archive.rows("surface/emitter", triangles, [this](std::size_t triangle, parallel::ArchiveRow& row) {
    row.value(low_passed_[triangle]);
    row.value(without_constant_[triangle]);
    surface_pressure_.archive(triangle, row);
    if (!fades_.empty()) {
      auto& [progress, area, normal] = fades_[triangle];
      row.value(progress);
      row.value(area);
      for (double& component : normal) {
        row.value(component);
      }
    }
  });
}

}  // namespace idiophone::surface
