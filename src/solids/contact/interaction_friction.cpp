// What the bonds between nodes and the partner do: Coulomb's friction, or friction with memory.

#include <algorithm>

#include "bristles.hpp"
#include "interaction.hpp"

namespace idiophone::contact {

void Interaction::compute_friction(BondUpdate bonds) {
  if (friction_.memory) {
    load_ = 0.0;
    for (const Side* side : sides()) {
      for (const Index node : side->touched) {
        load_ += side->touch[node].pressure * side->touch[node].surface;
      }
    }
  }
  if (friction_.sticking > 0 || friction_.memory) {
    for (Side* side : sides()) {
      rub(*side, bonds);
    }
  }
}

void Interaction::rub(Side& side, BondUpdate bonds) const {
  double depth = 0.0;  // the largest depth: there a bond is as stiff as the overlap, elsewhere softer
  for (const Index node : side.touched) {
    depth = std::max(depth, side.touch[node].pressure / stiffness_);
  }
  for (const Index node : side.touched) {
    Touch& touch = side.touch[node];
    Bond& bond = side.bond[node];
    if (touch.pressure == 0) {
      bond.let_go();
      continue;
    }
    const Vector3 normal = touch.area.normalized();
    const Vector3 velocity = touch.slip / touch.surface;
    const Vector3 slip = velocity - velocity.dot(normal) * normal;
    const Vector3 pull = friction_.memory ? bristle_pull(slip, normal, share_of_load(touch), bonds, bond)
                                          : coulomb_pull(slip, normal, depth, bonds, bond);
    touch.friction = -touch.pressure * pull;
  }
}

Vector3 Interaction::bristle_pull(const Vector3& slip, const Vector3& normal, double share, BondUpdate bonds,
                                  Bond& bond) const {
  if (bonds == BondUpdate::stretch) {
    const NodeBristles before{bond.stretch - bond.stretch.dot(normal) * normal, bond.share};
    const NodeBristles after = bend(*friction_.memory, before, slip, load_, share, step_);
    bond.stretch = after.deflection;
    bond.share = after.share;
  }
  return force_of_bristles(*friction_.memory, bond.stretch, slip, load_) / load_;
}

Vector3 Interaction::coulomb_pull(const Vector3& slip, const Vector3& normal, double depth, BondUpdate bonds,
                                  Bond& bond) const {
  if (bonds == BondUpdate::stretch) {
    bond.stretch += step_ * slip;
    bond.stretch -= bond.stretch.dot(normal) * normal;
    limit_stretch(slip, depth, bond);
  }
  Vector3 pull = bond.stretch / depth;
  if (!bond.sliding) {
    pull += damping_ / depth * slip;  // contact damping acts along the surface, too, while the bond holds
    pull *= std::min(1.0, friction_.sticking / std::max(pull.norm(), 1e-300));
  }
  return pull;
}

void Interaction::limit_stretch(const Vector3& slip, double depth, Bond& bond) const {
  const double stretch = bond.stretch.norm();
  bond.sliding = bond.sliding ? bond.stretch.dot(slip) > 0 : stretch > friction_.sticking * depth;
  // A bond that slides pulls with all that sliding friction can; one that holds, not with more than it can hold.
  const double limit = bond.sliding ? friction_.sliding * depth : std::min(stretch, friction_.sticking * depth);
  if (stretch > 0) {
    bond.stretch *= limit / stretch;
  }
}

double Interaction::share_of_load(const Touch& touch) const {
  return touch.pressure * touch.surface / load_;
}

double Interaction::energy_of_bond(const Touch& touch, const Bond& bond) const {
  return friction_.memory ? bond.share * friction_.memory->stiffness / 2 * bond.stretch.squaredNorm()
                          : -touch.surface / 2 * touch.friction.dot(bond.stretch);
}

}  // namespace idiophone::contact
