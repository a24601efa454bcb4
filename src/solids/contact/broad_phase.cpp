#include "broad_phase.hpp"

#include <algorithm>
#include <limits>

namespace idiophone::contact {

namespace {

/// Least margin: this part of the thinnest cell, for what sets bodies in motion between two updates.
constexpr double least_margin_divisor = 16;

/// Speed that other forces may give a body before the next update, times 4 as that of the margin, m/s.
constexpr double sudden_speed = 20.0;

constexpr double most_updates_to_skip = 63.0;

Box grown(const Box& box, double margin) {
  return box.isEmpty() ? box : Box(box.min() - Vector3::Constant(margin), box.max() + Vector3::Constant(margin));
}

double thinnest_cell(const std::vector<Side*>& sides) {
  const auto thinnest = [](const Side* side) { return side->skin.thinnest; };
  return thinnest(*std::ranges::min_element(sides, {}, thinnest));
}

}  // namespace

void Bounds::extend(const Bounds& other) {
  for (std::size_t side = 0; side < boxes.size(); ++side) {
    boxes[side].extend(other.boxes[side]);
  }
  velocities.extend(other.velocities);
  speed = std::max(speed, other.speed);
}

BroadPhase::BroadPhase(std::vector<Side*> sides, const RigidShape* shape, double interval)
    : sides_(std::move(sides)),
      shape_(shape),
      interval_(interval),
      least_margin_(thinnest_cell(sides_) / least_margin_divisor) {
  for (std::size_t part = 0; shape_ != nullptr && part < shape_->boxes.size(); ++part) {
    shape_box_.extend(shape_->boxes[part]);
  }
}

void BroadPhase::update(const Bounds& whole) {
  whole_ = whole;
  if (is_with_itself()) {
    whole_.boxes[1] = whole_.boxes[0];  // it may touch itself anywhere
  }
  margin_ = least_margin_ + 2 * closing_speed() * interval_;
}

double BroadPhase::closing_speed() const {
  const double both = 2 * whole_.speed;
  // What moves all of a body does not bring its parts together.
  return is_with_itself() && !whole_.velocities.isEmpty() ? std::min(both, whole_.velocities.diagonal().norm()) : both;
}

int BroadPhase::updates_to_skip() const {
  const double way = (4 * whole_.speed + sudden_speed) * interval_;  // between two updates
  const double updates = std::min((gap() - least_margin_) / way - 1, most_updates_to_skip);
  return updates > 0 ? static_cast<int>(updates) : 0;
}

double BroadPhase::gap() const {
  if (whole_.boxes[0].isEmpty() || (shape_ == nullptr && whole_.boxes[1].isEmpty())) {
    return 0.0;
  }
  if (shape_ == nullptr) {
    return whole_.boxes[0].exteriorDistance(whole_.boxes[1]);
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t part = 0; part < shape_->boxes.size(); ++part) {
    least = std::min(least, std::max(whole_.boxes[0].exteriorDistance(shape_->boxes[part]),
                                     distance_to_planes(whole_.boxes[0], part)));
  }
  return least;
}

bool BroadPhase::may_touch(const Bounds& part) const {
  if (shape_ != nullptr) {
    return near_shape(part.boxes[0]);
  }
  return grown(part.boxes[0], margin_).intersects(whole_.boxes[1]) ||
         grown(part.boxes[1], margin_).intersects(whole_.boxes[0]);
}

bool BroadPhase::near_shape(const Box& box) const {
  for (std::size_t part = 0; part < shape_->boxes.size(); ++part) {
    if (near_part(box, part)) {
      return true;
    }
  }
  return false;
}

bool BroadPhase::near_part(const Box& box, std::size_t part) const {
  return !box.isEmpty() && grown(box, margin_).intersects(shape_->boxes[part]) &&
         distance_to_planes(box, part) <= margin_;
}

double BroadPhase::distance_to_planes(const Box& box, std::size_t part) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (Index p = shape_->first_plane[part]; p < shape_->first_plane[part + 1]; ++p) {
    const Plane& plane = shape_->planes[p];
    // The box's corner that is deepest behind the plane.
    largest = std::max(largest, plane.distance(box.center()) - plane.normal.cwiseAbs().dot(box.sizes()) / 2);
  }
  return largest;
}

std::vector<SkinNode> BroadPhase::near_nodes(std::size_t s, const LocalSkin& skin) const {
  const Side& side = *sides_[s];
  const std::vector<std::uint8_t> beyond =
      sides_beyond(s, grown(shape_ != nullptr ? shape_box_ : whole_.boxes.at(1 - s), margin_), skin);
  std::vector<char> chosen(side.skin.nodes.size());
  for (const Index cell : skin.cells) {
    const auto& nodes = side.skin.cells[cell];
    const auto at = [&](std::size_t i) { return beyond[nodes.at(i)]; };
    if ((at(0) & at(1) & at(2) & at(3)) == 0 && (shape_ == nullptr || near_shape(side.box(cell)))) {
      for (const Index place : nodes) {
        chosen[place] = 1;
      }
    }
  }
  std::vector<SkinNode> near;
  std::ranges::copy_if(skin.owned, std::back_inserter(near),
                       [&](const SkinNode& node) { return chosen[node.place] != 0; });
  return near;
}

/// For each node, a bit for each side of the zone that it lies beyond: a cell whose nodes have one in common is
/// outside.
std::vector<std::uint8_t> BroadPhase::sides_beyond(std::size_t s, const Box& zone, const LocalSkin& skin) const {
  const Side& side = *sides_[s];
  std::vector<std::uint8_t> beyond(side.skin.nodes.size());
  const bool half_space = shape_ != nullptr && shape_->planes.size() == 1;
  for (const SkinNode& node : skin.nodes) {
    const Vector3& x = side.position[node.place];
    unsigned sides = half_space && shape_->planes[0].distance(x) > margin_ ? 1U : 0U;
    for (int axis = 0; axis < 3; ++axis) {
      sides |= (x[axis] < zone.min()[axis] ? 2U : 0U) << 2 * axis;
      sides |= (x[axis] > zone.max()[axis] ? 4U : 0U) << 2 * axis;
    }
    beyond[node.place] = static_cast<std::uint8_t>(sides);
  }
  return beyond;
}

std::vector<Index> BroadPhase::near_parts() const {
  std::vector<Index> parts;
  for (std::size_t part = 0; part < shape_->boxes.size(); ++part) {
    if (near_part(whole_.boxes[0], part)) {
      parts.push_back(static_cast<Index>(part));
    }
  }
  return parts;
}

}  // namespace idiophone::contact
