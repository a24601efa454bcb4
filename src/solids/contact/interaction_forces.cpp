// What overlaps do to the nodes: pressure, forces, and the sums over a contact.

#include <algorithm>
#include <cmath>

#include "interaction.hpp"

namespace idiophone::contact {

void Interaction::gather_touches() {
  for (const CellShare& share : overlaps_.cells()) {
    Side& own = side(share.side);
    const auto& nodes = own.skin.cells[share.cell];
    double divergence = 0.0;
    for (std::size_t j = 0; j < 4; ++j) {
      divergence += share.gradients.at(j).dot(own.velocity[nodes.at(j)]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      Touch& touch = touch_of(own, nodes.at(i));
      const double volume = share.volumes[i];
      touch.volume += volume;
      touch.growth += volume * divergence;
    }
  }
  for (const FaceShare& share : overlaps_.faces()) {
    Side& own = side(share.side);
    const auto& nodes = own.skin.cells[share.own_cell];
    for (Eigen::Index i = 0; i < 4; ++i) {
      Touch& touch = own.touch[nodes.at(i)];
      Vector3 slip = Vector3::Zero();
      for (Eigen::Index j = 0; j < 4; ++j) {
        const Index node = nodes.at(j);
        slip += share.own(i, j) * own.velocity[node];
        touch.moment += share.own(i, j) * own.position[node];
      }
      if (both_[1] != nullptr) {
        const Side& other = side(1 - share.side);
        const auto& partners = other.skin.cells[share.other_cell];
        for (Eigen::Index j = 0; j < 4; ++j) {
          slip -= share.other(i, j) * other.velocity[partners.at(j)];
        }
      }
      const double surface = share.own.row(i).sum();
      touch.surface += surface;
      touch.area += surface * share.normal;
      touch.slip += slip;
      touch.growth -= share.normal.dot(slip);
    }
  }
}

void Interaction::compute_normal_pressure(Side& side) {
  for (const Index node : side.touched) {
    Touch& touch = side.touch[node];
    const double area = side.skin.areas[node];
    if (area > 0 && touch.surface > 0) {
      touch.pressure = std::max(0.0, stiffness_ / area * (touch.volume + damping_ * touch.growth));
      // Where hardly any of the partner's surface is left inside, the volume alone says how deep it is.
      deepest_ = std::max(deepest_, std::min(touch.volume / touch.surface, std::cbrt(touch.volume)));
    }
  }
}

void Interaction::add_nodal_forces() {
  for (const CellShare& share : overlaps_.cells()) {
    Side& own = side(share.side);
    const auto& nodes = own.skin.cells[share.cell];
    double energy = 0.0;  // pressure times volume
    for (std::size_t i = 0; i < 4; ++i) {
      energy += own.touch[nodes.at(i)].pressure * share.volumes[i];
    }
    for (std::size_t j = 0; j < 4; ++j) {
      own.force[nodes.at(j)] -= energy * share.gradients.at(j);
    }
  }
  for (const FaceShare& share : overlaps_.faces()) {
    Side& own = side(share.side);
    const auto& nodes = own.skin.cells[share.own_cell];
    for (Eigen::Index i = 0; i < 4; ++i) {
      const Touch& touch = own.touch[nodes.at(i)];
      const Vector3 traction = touch.pressure * share.normal + touch.friction;
      for (Eigen::Index j = 0; j < 4; ++j) {
        own.force[nodes.at(j)] += share.own(i, j) * traction;
      }
      if (both_[1] != nullptr) {
        Side& other = side(1 - share.side);
        const auto& partners = other.skin.cells[share.other_cell];
        for (Eigen::Index j = 0; j < 4; ++j) {
          other.force[partners.at(j)] -= share.other(i, j) * traction;
        }
      }
    }
  }
}

double Interaction::energy() const {
  double energy = 0.0;
  for (const Side* side : sides()) {
    for (const Index node : side->touched) {
      const Touch& touch = side->touch[node];
      if (side->skin.areas[node] > 0) {
        energy += stiffness_ / 2 * touch.volume * touch.volume / side->skin.areas[node];
        energy += energy_of_bond(touch, side->bond[node]);
      }
    }
  }
  return energy;
}

ContactMotion Interaction::motion() const {
  ContactMotion motion;
  double weight = 0.0;
  Vector3 nodes = Vector3::Zero();  // mean place of the nodes that carry the pressure
  for (const Side* side : sides()) {
    for (const Index node : side->touched) {
      const Touch& touch = side->touch[node];
      const double sign = is_with_itself() ? side->bond[node].part : side == both_[0] ? 1.0 : -1.0;
      weight += touch.pressure * touch.surface;
      motion.point += touch.pressure * touch.moment;
      nodes += touch.pressure * touch.surface * side->position[node];
      // Places are linear in those of the nodes, so the sum of x_i times the integral of psi_i x is that of x x.
      motion.spread += touch.pressure * side->position[node] * touch.moment.transpose();
      motion.normal += sign * touch.pressure * touch.area;
      motion.slip += sign * touch.pressure * touch.slip;
      motion.force += sign * (touch.pressure * touch.area + touch.surface * touch.friction);
    }
  }
  motion.overlap = overlaps_.volume();
  if (weight > 0) {
    motion.point /= weight;
    // Where nodes press unevenly, their mean place is not that of the pressure.
    const Eigen::Matrix3d products = motion.spread / weight - nodes / weight * motion.point.transpose();
    motion.spread = (products + products.transpose()) / 2;
    motion.normal.normalize();
    motion.slip /= weight;
    motion.slip -= motion.slip.dot(motion.normal) * motion.normal;
  }
  return motion;
}

}  // namespace idiophone::contact
