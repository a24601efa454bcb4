#include <algorithm>
#include <cmath>

#include "idiophone/scene/room_section.hpp"

namespace idiophone::scene {

namespace {

double energy_loss(double absorption) {
  constexpr double least = 1e-12;                                      // of the energy, after a reflection
  return std::max(0.0, -std::log(std::max(least, 1.0 - absorption)));  // not -0
}

}  // namespace

double Room::wall_area(std::size_t wall) const {
  return volume() / size[static_cast<Eigen::Index>(wall / 2)];
}

double Room::surface() const {
  return 2.0 * (wall_area(0) + wall_area(2) + wall_area(4));
}

double Room::distance_outside(const Vector3& point) const {
  const Vector3 below = corner - point;
  const Vector3 above = point - corner - size;
  return std::max({0.0, below.maxCoeff(), above.maxCoeff()});
}

bool Room::absorbs_evenly() const {
  return std::ranges::all_of(absorption, [](const OctaveBands& bands) {
    return std::ranges::all_of(bands, [&](double value) { return value == bands.front(); });
  });
}

double Room::loss(std::size_t wall, std::size_t band) const {
  return energy_loss(absorption.at(wall).at(band));
}

double Room::decay_rate(std::size_t band, double speed) const {
  double absorbed = 0.0;
  for (std::size_t wall = 0; wall < walls; ++wall) {
    absorbed += wall_area(wall) * absorption.at(wall).at(band);
  }
  return 0.25 * speed * surface() / volume() * energy_loss(absorbed / surface());
}

int Room::order() const {
  if (images) {
    return *images;
  }
  const double sixty_decibels = 6.0 * std::log(10.0);
  double least = sixty_decibels;  // loss in a mean reflection
  for (std::size_t band = 0; band < OctaveBands().size(); ++band) {
    // The mean over the walls, from the decay with c = 1 and a mean free path of 4 V/S.
    least = std::min(least, decay_rate(band, 1.0) * 4.0 * volume() / surface());
  }
  const int most = late ? 3 : 10;
  return least * most > sixty_decibels ? static_cast<int>(std::ceil(sixty_decibels / least - 1e-9)) : most;
}

}  // namespace idiophone::scene
