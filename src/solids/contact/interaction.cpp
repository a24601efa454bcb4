#include "interaction.hpp"

#include <algorithm>

#include "parts.hpp"
#include "side_cell.hpp"

namespace idiophone::contact {

Interaction::Interaction(const scene::Contact& contact, double stiffness, double step, Side& first, Side& second)
    : friction_(contact.friction),
      damping_(contact.damping),
      stiffness_(stiffness / 2),
      step_(step),
      both_{&first, &second},
      near_pairs_(first, &second, nullptr) {}

Interaction::Interaction(const scene::Contact& contact, double stiffness, double step, Side& first,
                         const RigidShape& second)
    : friction_(contact.friction),
      damping_(contact.damping),
      stiffness_(stiffness),
      step_(step),
      both_{&first, nullptr},
      shape_(&second),
      near_pairs_(first, nullptr, &second) {}

void Interaction::find_near_pairs() {
  clear();
  near_pairs_.find();
}

void Interaction::compute_forces(BondUpdate bonds) {
  gather_touches();
  for (Side* side : sides()) {
    for (const Index node : side->bonded) {
      if (!side->touch[node].any) {
        side->bond[node] = {};
      }
    }
    side->bonded = side->touched;
    compute_normal_pressure(*side);
  }
  if (is_with_itself()) {
    choose_parts(overlaps_.faces(), side(0));
  }
  compute_friction(bonds);
  add_nodal_forces();
}

void Interaction::release() {
  clear();
  for (Side* side : sides()) {
    for (const Index node : side->bonded) {
      side->bond[node] = {};
    }
    side->bonded.clear();
  }
  near_pairs_.clear_all();
}

void Interaction::clear() {
  for (Side* side : sides()) {
    for (const Index node : side->touched) {
      side->touch[node] = {};
    }
    side->touched.clear();
  }
  near_pairs_.clear();
  overlaps_.clear();
}

void Interaction::find_overlaps(const Portion& portion) {
  const std::span<const NearPairs::Pair> pairs = near_pairs_.found();
  const std::size_t begin = pairs.size() * portion.number / portion.count;
  const std::size_t end = pairs.size() * (portion.number + 1) / portion.count;
  for (const auto& [a, b] : pairs.subspan(begin, end - begin)) {
    const SideCell first(*both_[0], a);
    if (both_[1] != nullptr) {
      const SideCell second(*both_[1], b);
      overlaps_.add(first.view(), second.view());
    } else {
      overlaps_.add(first.view(), part_of(*shape_, b));
    }
  }
}

Touch& Interaction::touch_of(Side& side, Index node) {
  Touch& touch = side.touch[node];
  if (!touch.any) {
    touch.any = true;
    side.touched.push_back(node);
    side.force[node].setZero();
  }
  return touch;
}

}  // namespace idiophone::contact
