#include "idiophone/air/waves/enclosing_box.hpp"

#include "idiophone/foundation/lanes.hpp"

namespace idiophone::waves {

EnclosingBox::EnclosingBox(const Subdomain& subdomain, const Enclosure& enclosure) : cell_(subdomain.grid().cell) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      if (subdomain.grid().layer_at(axis, end) > 0) {  // a rigid wall closes the box
        add_side(subdomain, enclosure, axis, end);
      }
    }
  }
  emission_.resize(padded(patches_.size()));
  emission_.pressure_gradient.resize(padded(patches_.size()));
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
        patches_.push_back({inside, inside + outwards});
        numbers_.push_back(global_patches_);
        const std::size_t i = patches_.size() - 1;
        emission_.resize(padded(patches_.size()));
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

const surface::Emission& EnclosingBox::emission(const WaveField& field) {
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const double inside = field.pressure(patches_[i].inside);
    const double outside = field.pressure(patches_[i].outside);
    emission_.surface_pressure[i] = 0.5 * (inside + outside);
    emission_.pressure_gradient[i] = (outside - inside) / cell_;
  }
  return emission_;
}

}  // namespace idiophone::waves
