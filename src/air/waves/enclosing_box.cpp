#include "idiophone/air/waves/enclosing_box.hpp"

#include <span>

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::waves {

EnclosingBox::EnclosingBox(const WaveField& field, const Enclosure& enclosure) : cell_(field.subdomain().grid().cell) {
  const Subdomain& subdomain = field.subdomain();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      if (subdomain.grid().layer_at(axis, end) > 0) {  // a rigid wall closes the box
        add_side(subdomain, enclosure, axis, end);
      }
    }
  }
  emission_.resize(padded(patches()));
  emission_.pressure_gradient.resize(padded(patches()));
  probe_ = field.probe(cells_);
}

void EnclosingBox::add_side(const Subdomain& subdomain, const Enclosure& enclosure, std::size_t axis, int end) {
  const Grid& grid = subdomain.grid();
  auto from = enclosure.from;
  auto to = enclosure.to;
  (end == 0 ? to : from).at(axis) = end == 0 ? from.at(axis) + 1 : to.at(axis) - 1;
  const Index outwards = (end == 0 ? -1 : 1) * subdomain.stride(axis);
  Vector3 normal = Vector3::Zero();
  normal[static_cast<Eigen::Index>(axis)] = end == 0 ? -1.0 : 1.0;
  for (int z = from[2]; z < to[2]; ++z) {
    for (int y = from[1]; y < to[1]; ++y) {
      for (int x = from[0]; x < to[0]; ++x, ++global_patches_) {
        if (!subdomain.owns({x, y, z})) {
          continue;
        }
        const Index inside = subdomain.number({x, y, z});
        cells_.insert(cells_.end(), {inside, inside + outwards});
        const std::size_t i = patches();
        numbers_.push_back(global_patches_);
        emission_.resize(padded(patches()));
        const Vector3 centre = grid.corner + grid.cell * (Vector3(x + 0.5, y + 0.5, z + 0.5) + 0.5 * normal);
        for (std::size_t k = 0; k < 3; ++k) {
          emission_.centre[k][i] = centre[static_cast<Eigen::Index>(k)];
          emission_.normal[k][i] = normal[static_cast<Eigen::Index>(k)];
        }
        emission_.area[i] = grid.cell * grid.cell;
      }
    }
  }
}

const surface::Emission& EnclosingBox::finish() {
  const std::span<const float> pressures = probe_->finish();
  for (std::size_t i = 0; i < patches(); ++i) {
    const double inside = pressures[2 * i], outside = pressures[2 * i + 1];
    emission_.surface_pressure[i] = 0.5 * (inside + outside);
    emission_.pressure_gradient[i] = (outside - inside) / cell_;
  }
  return emission_;
}

}  // namespace idiophone::waves
