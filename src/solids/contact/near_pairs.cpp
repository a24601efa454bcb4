#include "near_pairs.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "side_cell.hpp"

namespace idiophone::contact {

namespace {

/// Close pairs are within this part of the thinnest cell of each other: it lasts for many steps, and few pairs are so
/// close.
constexpr double reach_divisor = 2;

Box within(const Box& box, double margin) {
  return {box.min() - Vector3::Constant(margin), box.max() + Vector3::Constant(margin)};
}

}  // namespace

NearPairs::NearPairs(const Side& first, const Side* second, const RigidShape* shape)
    : first_(&first),
      second_(second),
      shape_(shape),
      reach_(std::min(first.skin.thinnest, second != nullptr ? second->skin.thinnest : first.skin.thinnest) /
             reach_divisor) {
  if (first_ == second_) {
    neighbours_.emplace(first.skin);
  }
}

void NearPairs::choose_candidates(const std::vector<Index>& first, const std::vector<Index>& second, double margin) {
  clear_all();
  cells_ = {first, second};
  find_boxes();
  // Sweep along the longest axis: only cells whose intervals overlap there are compared.
  const int axis = longest_axis();
  std::vector<Index> sweep(second.size());
  std::iota(sweep.begin(), sweep.end(), 0);
  const auto left = [&](Index place) { return boxes_[1][place].min()[axis]; };
  std::ranges::sort(sweep, {}, left);
  double widest = 0.0;
  for (const Box& box : boxes_[1]) {
    widest = std::max(widest, box.max()[axis] - box.min()[axis]);
  }
  for (std::size_t place = 0; place < first.size(); ++place) {
    const Box box = within(boxes_[0][place], margin);
    if (neighbours_) {
      neighbours_->look_from(first[place]);
    }
    for (auto partner = std::ranges::lower_bound(sweep, box.min()[axis] - widest, {}, left);
         partner != sweep.end() && left(*partner) <= box.max()[axis]; ++partner) {
      if (is_met_first(first[place], second[*partner]) && box.intersects(boxes_[1][*partner]) &&
          !(neighbours_ && neighbours_->is_near(second[*partner]))) {
        candidates_.emplace_back(static_cast<Index>(place), *partner);
      }
    }
  }
  std::ranges::sort(candidates_);
  keep_cells_of_candidates();
}

/// Of all boxes of the second partner.
int NearPairs::longest_axis() const {
  Box whole;
  std::ranges::for_each(boxes_[1], [&](const Box& box) { whole.extend(box); });
  int axis = 0;
  whole.sizes().maxCoeff(&axis);
  return axis;
}

void NearPairs::keep_cells_of_candidates() {
  for (std::size_t s = 0; s < 2; ++s) {
    const auto place_of = [&](Pair& pair) -> Index& { return s == 0 ? pair.first : pair.second; };
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

void NearPairs::find() {
  found_.clear();
  find_boxes();
  find_corners();
  if (!(way_since_chosen() < reach_ / 2)) {  // half, so that rounding never matters
    choose_close_pairs();
  }
  for (const auto& [first, second] : close_) {
    if (boxes_[0][first].intersects(boxes_[1][second])) {
      found_.emplace_back(cells_[0][first], cells_[1][second]);
    }
  }
}

Box NearPairs::box(std::size_t partner, Index cell) const {
  if (partner == 0) {
    return first_->box(cell);
  }
  return shape_ != nullptr ? shape_->boxes[cell] : second_->box(cell);
}

void NearPairs::find_boxes() {
  for (std::size_t s = 0; s < 2; ++s) {
    boxes_.at(s).clear();
    std::ranges::transform(cells_.at(s), std::back_inserter(boxes_.at(s)), [&](Index cell) { return box(s, cell); });
  }
}

void NearPairs::find_corners() {
  for (std::size_t s = 0; s < 2; ++s) {
    corners_.at(s).clear();
    if (const Side* const side = s == 0 ? first_ : second_) {
      for (const Index cell : cells_.at(s)) {
        std::ranges::transform(side->skin.cells[cell], std::back_inserter(corners_.at(s)),
                               [side](Index node) { return side->position[node]; });
      }
    }
  }
}

/// The farthest that corners have come nearer to each other along any axis, m, or more: what all of them moved together
/// does not count. Boxes do not tell it: a corner inside of its cell's box can move without it.
double NearPairs::way_since_chosen() const {
  Box ways;
  if (shape_ != nullptr) {
    ways.extend(Vector3(Vector3::Zero()));  // it stays
  }
  for (std::size_t s = 0; s < 2; ++s) {
    const std::vector<Vector3>& now = corners_.at(s);
    if (chosen_.at(s).size() != now.size()) {
      return std::numeric_limits<double>::infinity();
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
      ways.extend(now[i] - chosen_.at(s)[i]);
    }
  }
  return ways.isEmpty() ? 0.0 : ways.sizes().maxCoeff();
}

void NearPairs::choose_close_pairs() {
  chosen_ = corners_;
  close_.clear();
  std::optional<SideCell> first;
  Index place = -1;  // of `first`
  for (const Pair& candidate : candidates_) {
    if (!within(boxes_[0][candidate.first], reach_).intersects(boxes_[1][candidate.second])) {
      continue;
    }
    if (place != candidate.first) {
      place = candidate.first;
      first.emplace(*first_, cells_[0][place]);
    }
    if (!are_apart(first->view(), cells_[1][candidate.second])) {
      close_.push_back(candidate);
    }
  }
}

/// Whether two cells cannot meet before close pairs are chosen again: what is less than half the reach along each axis
/// is less than the reach along a normal.
bool NearPairs::are_apart(const Cell& first, Index second) const {
  return shape_ != nullptr ? separated(first, part_of(*shape_, second), reach_)
                           : separated(first, SideCell(*second_, second).view(), reach_);
}

void NearPairs::clear_all() {
  candidates_.clear();
  close_.clear();
  found_.clear();
  chosen_ = {};
}

}  // namespace idiophone::contact
