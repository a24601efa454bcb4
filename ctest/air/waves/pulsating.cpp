#include "pulsating.hpp"

#include <cmath>

namespace idiophone::waves {

Grid grid_of(std::array<int, 3> cells, int layer) {
  return {.corner = Vector3(-0.163, -0.141, -0.152), .cell = 0.01, .cells = cells, .layer = layer};
}

void PrintTo(const Setting& setting, std::ostream* out) {
  *out << setting.name;
}

std::vector<Setting> settings() {
  constexpr LossyAir very_lossy = {.viscosity = 0.01, .diffusivity = 0.01};
  const Setting odd = {"odd", grid_of({32, 27, 31}, 6), 0.06, std::nullopt};
  Setting floor = odd;
  floor.name = "floor";
  floor.grid.rigid_below = true;
  const Grid is_long{.corner = Vector3(-0.943, -0.071, -0.062), .cell = 0.01, .cells = {176, 15, 13}, .layer = 3};
  return {odd, {"lossy", odd.grid, odd.radius, very_lossy}, {"long", is_long, 0.03, very_lossy}, floor};
}

Pulsating::Pulsating(const Setting& setting, int ranks, MPI_Comm communicator, accelerator::Accelerator* accelerator)
    : field_(Division(setting.grid, ranks), test_courant, communicator, setting.lossy, accelerator),
      solid_(radiation::icosphere(setting.radius, 4)),
      history_(solid_.triangles.size(), 3) {
  set(Vector3::Zero());
}

void Pulsating::set(const Vector3& shift) {
  positions_.clear();
  for (const Vector3& vertex : solid_.vertices) {
    const Vector3 place = vertex + shift;
    positions_.insert(positions_.end(), place.begin(), place.end());
  }
  const Obstruction obstruction{solid_.triangles, positions_};
  CutCells cells(field_.subdomain(), obstruction, test_courant, field_.is_lossy());
  sources_ = SurfaceSources(field_.subdomain(), obstruction, solid_.triangles.size(), cells, test_courant);
  node_sources_.resize(cells.nodes().size());
  field_.set_surfaces(std::move(cells));
}

void Pulsating::advance_samples(int samples) {
  std::vector<float> velocities(history_.signals());
  for (int i = 0; i < samples; ++i, ++step_) {
    for (std::size_t triangle = 0; triangle < velocities.size(); ++triangle) {
      velocities[triangle] = static_cast<float>(std::sin(0.3 * step_ + 0.1 * static_cast<double>(triangle)));
    }
    history_.push(velocities);
    for (int step = 0; step < history_.steps(); ++step) {
      field_.step(sources_, history_, step);
    }
  }
}

void Pulsating::advance(int steps) {
  for (int i = 0; i < steps; ++i, ++step_) {
    const double x = (step_ - 20.0) / 6.0;
    changes_.assign(solid_.triangles.size(), static_cast<float>(-x * std::exp(-0.5 * x * x)));
    sources_.add(changes_, node_sources_);
    field_.step(node_sources_);
  }
}

}  // namespace idiophone::waves
