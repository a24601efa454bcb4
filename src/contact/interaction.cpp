#include "interaction.hpp"

#include <algorithm>

namespace idiophone::contact {

Interaction::Interaction(const scene::Contact& contact, double stiffness, double step, Side& first, Side& second)
    : friction_(contact.friction),
      damping_(contact.damping),
      stiffness_(stiffness / 2),
      step_(step),
      first_(&first),
      second_(&second) {}

Interaction::Interaction(const scene::Contact& contact, double stiffness, double step, Side& first,
                         const RigidShape& second)
    : friction_(contact.friction),
      damping_(contact.damping),
      stiffness_(stiffness),
      step_(step),
      first_(&first),
      shape_(&second) {}

void Interaction::choose_candidates(const std::vector<Index>& first, const std::vector<Index>& second, double margin) {
  struct Boxed {
    Box box;
    Index cell;
  };
  // Sweep along x: only cells whose intervals overlap there are compared.
  std::vector<Boxed> partners;
  for (const Index cell : second) {
    partners.push_back({second_ != nullptr ? second_->box(cell) : shape_->boxes[static_cast<std::size_t>(cell)], cell});
  }
  std::ranges::sort(partners, {}, [](const Boxed& partner) { return partner.box.min().x(); });
  double widest = 0.0;
  for (const Boxed& partner : partners) {
    widest = std::max(widest, partner.box.max().x() - partner.box.min().x());
  }
  candidates_.clear();
  for (const Index cell : first) {
    const Box box(first_->box(cell).min() - Vector3::Constant(margin),
                  first_->box(cell).max() + Vector3::Constant(margin));
    auto partner = std::ranges::lower_bound(partners, box.min().x() - widest, {},
                                            [](const Boxed& each) { return each.box.min().x(); });
    for (; partner != partners.end() && partner->box.min().x() <= box.max().x(); ++partner) {
      if (box.intersects(partner->box)) {
        candidates_.emplace_back(cell, partner->cell);
      }
    }
  }
  std::ranges::sort(candidates_);
}

void Interaction::act(bool moved) {
  clear();
  find_overlaps();
  share_out();
  for (std::size_t which = 0; which < (second_ != nullptr ? 2U : 1U); ++which) {
    Side& side = this->side(static_cast<int>(which));
    for (const Index node : touched_before_.at(which)) {
      if (!side.touch[static_cast<std::size_t>(node)].any) {
        side.bond[static_cast<std::size_t>(node)] = {};
      }
    }
    press(side);
    if (friction_.sticking > 0) {
      rub(side, moved);
    }
  }
  push();
}

void Interaction::part() {
  clear();
  for (std::size_t which = 0; which < (second_ != nullptr ? 2U : 1U); ++which) {
    for (const Index node : touched_before_.at(which)) {
      side(static_cast<int>(which)).bond[static_cast<std::size_t>(node)] = {};
    }
    touched_before_.at(which).clear();
  }
  candidates_.clear();
}

void Interaction::clear() {
  for (std::size_t which = 0; which < (second_ != nullptr ? 2U : 1U); ++which) {
    Side& side = this->side(static_cast<int>(which));
    for (const Index node : side.touched) {
      side.touch[static_cast<std::size_t>(node)] = {};
    }
    touched_before_.at(which).swap(side.touched);
    side.touched.clear();
  }
  overlaps_.clear();
}

void Interaction::find_overlaps() {
  for (const auto& [a, b] : candidates_) {
    const Box box = first_->box(a);
    if (!box.intersects(second_ != nullptr ? second_->box(b) : shape_->boxes[static_cast<std::size_t>(b)])) {
      continue;
    }
    const Tetrahedron mine = first_->tetrahedron(a);
    const std::array<Plane, 4> my_planes = {mine.plane(0), mine.plane(1), mine.plane(2), mine.plane(3)};
    const Cell first{a, &mine, my_planes, first_->skin.exterior[static_cast<std::size_t>(a)]};
    if (second_ != nullptr) {
      const Tetrahedron other = second_->tetrahedron(b);
      const std::array<Plane, 4> planes = {other.plane(0), other.plane(1), other.plane(2), other.plane(3)};
      overlaps_.add(first, {b, &other, planes, second_->skin.exterior[static_cast<std::size_t>(b)]});
    } else {
      const auto begin = static_cast<std::size_t>(shape_->first_plane[static_cast<std::size_t>(b)]);
      const auto count = static_cast<std::size_t>(shape_->first_plane[static_cast<std::size_t>(b) + 1]) - begin;
      overlaps_.add(first, {b, nullptr, std::span(shape_->planes).subspan(begin, count),
                            std::span(shape_->exterior).subspan(begin, count)});
    }
  }
}

Touch& Interaction::reach(Side& side, Index node) {
  Touch& touch = side.touch[static_cast<std::size_t>(node)];
  if (!touch.any) {
    touch.any = true;
    side.touched.push_back(node);
    side.force[static_cast<std::size_t>(node)].setZero();
  }
  return touch;
}

}  // namespace idiophone::contact
