#include "interaction.hpp"

#include <algorithm>
#include <numeric>

namespace idiophone::contact {

Interaction::Interaction(const scene::Contact& contact, double stiffness, double step, Side& first, Side& second)
    : friction_(contact.friction),
      damping_(contact.damping),
      stiffness_(stiffness / 2),
      step_(step),
      both_{&first, &second} {
  if (is_with_itself()) {
    neighbours_.emplace(first.skin);
  }
}

Interaction::Interaction(const scene::Contact& contact, double stiffness, double step, Side& first,
                         const RigidShape& second)
    : friction_(contact.friction),
      damping_(contact.damping),
      stiffness_(stiffness),
      step_(step),
      both_{&first, nullptr},
      shape_(&second) {}

void Interaction::choose_candidates(const std::vector<Index>& first, const std::vector<Index>& second, double margin) {
  cells_ = {first, second};
  find_boxes();
  // Sweep along the longest axis: only cells whose intervals overlap there are compared.
  Box whole;
  std::ranges::for_each(boxes_[1], [&](const Box& box) { whole.extend(box); });
  int axis = 0;
  whole.sizes().maxCoeff(&axis);
  std::vector<Index> sweep(second.size());
  std::iota(sweep.begin(), sweep.end(), 0);
  const auto left = [&](Index place) { return boxes_[1][place].min()[axis]; };
  std::ranges::sort(sweep, {}, left);
  double widest = 0.0;
  for (const Box& box : boxes_[1]) {
    widest = std::max(widest, box.max()[axis] - box.min()[axis]);
  }
  candidates_.clear();
  for (std::size_t place = 0; place < first.size(); ++place) {
    const Vector3 more = Vector3::Constant(margin);
    const Box box(boxes_[0][place].min() - more, boxes_[0][place].max() + more);
    if (neighbours_) {
      neighbours_->look_from(first[place]);
    }
    for (auto partner = std::ranges::lower_bound(sweep, box.min()[axis] - widest, {}, left);
         partner != sweep.end() && left(*partner) <= box.max()[axis]; ++partner) {
      if (box.intersects(boxes_[1][*partner]) && can_meet(first[place], second[*partner])) {
        candidates_.emplace_back(static_cast<Index>(place), *partner);
      }
    }
  }
  std::ranges::sort(candidates_);
  keep_cells_of_candidates();
}

/// Of a body with itself, each pair is met once, and neighbours never meet.
bool Interaction::can_meet(Index first, Index second) const {
  return !neighbours_ || (first < second && !neighbours_->is_near(second));
}

void Interaction::keep_cells_of_candidates() {
  for (std::size_t s = 0; s < 2; ++s) {
    const auto place_of = [&](std::pair<Index, Index>& pair) -> Index& { return s == 0 ? pair.first : pair.second; };
    std::vector<Index> kept, new_place(cells_.at(s).size(), -1);
    std::ranges::for_each(candidates_, [&](auto& candidate) { new_place[place_of(candidate)] = 0; });
    for (std::size_t place = 0; place < new_place.size(); ++place) {
      if (new_place[place] == 0) {
        new_place[place] = static_cast<Index>(kept.size());
        kept.push_back(cells_.at(s)[place]);
      }
    }
    std::ranges::for_each(candidates_, [&](auto& candidate) { place_of(candidate) = new_place[place_of(candidate)]; });
    cells_.at(s) = std::move(kept);
  }
}

void Interaction::find_boxes() {
  for (std::size_t s = 0; s < 2; ++s) {
    boxes_.at(s).clear();
    for (const Index cell : cells_.at(s)) {
      boxes_.at(s).push_back(s == 1 && shape_ != nullptr ? shape_->boxes[cell] : side(static_cast<int>(s)).box(cell));
    }
  }
}

void Interaction::find_near_pairs() {
  clear();
  find_boxes();
  std::ranges::copy_if(candidates_, std::back_inserter(near_), [&](const std::pair<Index, Index>& candidate) {
    return boxes_[0][candidate.first].intersects(boxes_[1][candidate.second]);
  });
}

void Interaction::compute_forces(BondUpdate bonds) {
  gather_touches();
  for (std::size_t which = 0; which < sides().size(); ++which) {
    Side& side = this->side(static_cast<int>(which));
    for (const Index node : touched_before_.at(which)) {
      if (!side.touch[node].any) {
        side.bond[node] = {};
      }
    }
    compute_normal_pressure(side);
  }
  compute_friction(bonds);
  add_nodal_forces();
}

void Interaction::release() {
  clear();
  for (std::size_t which = 0; which < sides().size(); ++which) {
    for (const Index node : touched_before_.at(which)) {
      side(static_cast<int>(which)).bond[node] = {};
    }
    touched_before_.at(which).clear();
  }
  candidates_.clear();
}

void Interaction::clear() {
  for (std::size_t which = 0; which < sides().size(); ++which) {
    Side& side = this->side(static_cast<int>(which));
    for (const Index node : side.touched) {
      side.touch[node] = {};
    }
    touched_before_.at(which).swap(side.touched);
    side.touched.clear();
  }
  near_.clear();
  overlaps_.clear();
}

void Interaction::find_overlaps(const Portion& portion) {
  const std::size_t begin = near_.size() * portion.number / portion.count;
  const std::size_t end = near_.size() * (portion.number + 1) / portion.count;
  for (const auto& [i, j] : std::span(near_).subspan(begin, end - begin)) {
    const Index a = cells_[0][i];
    const Index b = cells_[1][j];
    const Tetrahedron mine = both_[0]->tetrahedron(a);
    const std::array<Plane, 4> my_planes = {mine.plane(0), mine.plane(1), mine.plane(2), mine.plane(3)};
    const Cell first{a, &mine, my_planes, both_[0]->skin.exterior[a]};
    if (both_[1] != nullptr) {
      const Tetrahedron other = both_[1]->tetrahedron(b);
      const std::array<Plane, 4> planes = {other.plane(0), other.plane(1), other.plane(2), other.plane(3)};
      overlaps_.add(first, {b, &other, planes, both_[1]->skin.exterior[b]});
    } else {
      const Index plane = shape_->first_plane[b];
      const Index count = shape_->first_plane[b + 1] - plane;
      overlaps_.add(first, {b, nullptr, std::span(shape_->planes).subspan(plane, count),
                            std::span(shape_->exterior).subspan(plane, count)});
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
