#include "meeting.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::contact {

namespace {

/// Least margin: this part of the thinnest cell, for what sets bodies in motion between two looks.
constexpr double reach_divisor = 16;

Box grown(const Box& box, double margin) {
  return box.isEmpty() ? box : Box(box.min() - Vector3::Constant(margin), box.max() + Vector3::Constant(margin));
}

Box around(const RigidShape& shape) {
  Box box;
  for (const Box& part : shape.boxes) {
    box.extend(part);
  }
  return box;
}

}  // namespace

Meeting::Meeting(Side& first, Side* second, const RigidShape* shape, const mesh::Part& part, double interval,
                 MPI_Comm communicator)
    : first_(&first),
      second_(second),
      shape_(shape),
      sides_(second != nullptr ? 2 : 1),
      communicator_(communicator),
      interval_(interval),
      reach_(first.skin.thinnest / reach_divisor),
      shape_box_(shape != nullptr ? around(*shape) : Box()) {
  int ranks = 1;
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &ranks);
  std::vector<std::pair<Index, Index>> local;  // global number, local number
  for (std::size_t node = 0; node < part.node_ids.size(); ++node) {
    local.emplace_back(part.node_ids[node], static_cast<Index>(node));
  }
  std::ranges::sort(local);
  for (std::size_t s = 0; s < sides_; ++s) {
    find_local(s, local, part);
    reach_ = std::min(reach_, side(s).skin.thinnest / reach_divisor);
  }
  const char mine = own_[0].empty() && own_[1].empty() ? 0 : 1;
  std::vector<char> all(static_cast<std::size_t>(ranks));
  MPI_Allgather(&mine, 1, MPI_CHAR, all.data(), 1, MPI_CHAR, communicator_);
  for (int rank = 0; rank < ranks && mine != 0; ++rank) {
    if (rank != rank_ && all[static_cast<std::size_t>(rank)] != 0) {
      peers_.push_back({rank, {}, false, {}});
    }
  }
}

void Meeting::find_local(std::size_t s, const std::vector<std::pair<Index, Index>>& local, const mesh::Part& part) {
  const Skin& skin = side(s).skin;
  std::vector<Index> numbers(skin.nodes.size(), -1);  // local ones
  for (std::size_t place = 0; place < skin.nodes.size(); ++place) {
    const auto found = std::ranges::lower_bound(local, skin.nodes[place], {}, &std::pair<Index, Index>::first);
    if (found != local.end() && found->first == skin.nodes[place]) {
      numbers[place] = found->second;
    }
  }
  const auto owned = [&](Index place) {
    const Index node = numbers[static_cast<std::size_t>(place)];
    return node >= 0 && node < part.owned_nodes;
  };
  std::vector<char> here(skin.nodes.size());
  for (std::size_t cell = 0; cell < skin.cells.size(); ++cell) {
    if (std::ranges::any_of(skin.cells[cell], owned)) {
      cells_here_.at(s).push_back(static_cast<Index>(cell));
      for (const Index place : skin.cells[cell]) {
        here[static_cast<std::size_t>(place)] = 1;
      }
    }
  }
  for (std::size_t place = 0; place < here.size(); ++place) {
    if (here[place] == 0) {
      continue;
    }
    const SkinNode node{static_cast<Index>(place), numbers[place]};
    here_.at(s).push_back(node);
    side(s).reference[place] = part.reference[static_cast<std::size_t>(node.node)];
    if (owned(node.place)) {
      own_.at(s).push_back(node);
    }
  }
}

void Meeting::look(const solid::NodeState* state) {
  if (own_[0].empty() && own_[1].empty()) {
    return;
  }
  const Whereabouts mine = whereabouts(state);
  tell(mine);
  Whereabouts whole = mine;
  for (const Peer& peer : peers_) {
    whole.speed = std::max(whole.speed, peer.whereabouts.speed);
    for (std::size_t s = 0; s < sides_; ++s) {
      whole.boxes.at(s).extend(peer.whereabouts.boxes.at(s));
    }
  }
  margin_ = reach_ + 4 * whole.speed * interval_;
  near_ = may_meet(mine, whole);
  for (Peer& peer : peers_) {
    peer.near = near_ && may_meet(peer.whereabouts, whole);
  }
  if (near_) {
    choose_nodes(whole);
    announce();
    gather_cells(whole);
  }
}

Meeting::Whereabouts Meeting::whereabouts(const solid::NodeState* state) {
  Whereabouts mine;
  double squared_speed = 0.0;
  for (std::size_t s = 0; s < sides_; ++s) {
    for (const SkinNode& node : here_.at(s)) {
      place(s, node, state);
      mine.boxes.at(s).extend(side(s).position[static_cast<std::size_t>(node.place)]);
    }
    for (const SkinNode& node : own_.at(s)) {
      squared_speed = std::max(squared_speed, side(s).velocity[static_cast<std::size_t>(node.place)].squaredNorm());
    }
  }
  mine.speed = std::sqrt(squared_speed);
  return mine;
}

void Meeting::place(std::size_t s, const SkinNode& node, const solid::NodeState* state) {
  const auto place = static_cast<std::size_t>(node.place);
  const solid::NodeState& now = state[node.node];
  side(s).position[place] = side(s).reference[place] + Eigen::Map<const Vector3>(now.displacement);
  side(s).velocity[place] = Eigen::Map<const Vector3>(now.velocity);
}

bool Meeting::may_meet(const Whereabouts& part, const Whereabouts& whole) const {
  if (shape_ != nullptr) {
    return near_shape(part.boxes[0]);
  }
  return grown(part.boxes[0], margin_).intersects(whole.boxes[1]) ||
         grown(part.boxes[1], margin_).intersects(whole.boxes[0]);
}

bool Meeting::near_shape(const Box& box) const {
  for (std::size_t p = 0; p < shape_->boxes.size(); ++p) {
    if (near_part(box, p)) {
      return true;
    }
  }
  return false;
}

bool Meeting::near_part(const Box& box, std::size_t part) const {
  if (box.isEmpty() || !grown(box, margin_).intersects(shape_->boxes[part])) {
    return false;
  }
  for (Index p = shape_->first_plane[part]; p < shape_->first_plane[part + 1]; ++p) {
    const Plane& plane = shape_->planes[static_cast<std::size_t>(p)];
    // The box's corner that is deepest behind the plane.
    if (plane.distance(box.center()) - plane.normal.cwiseAbs().dot(box.sizes()) / 2 > margin_) {
      return false;
    }
  }
  return true;
}

void Meeting::choose_nodes(const Whereabouts& whole) {
  for (std::size_t s = 0; s < sides_; ++s) {
    const std::vector<std::uint8_t> beyond =
        sides_beyond(s, grown(shape_ != nullptr ? shape_box_ : whole.boxes.at(1 - s), margin_));
    std::vector<char> chosen(side(s).skin.nodes.size());
    for (const Index cell : cells_here_.at(s)) {
      const auto& nodes = side(s).skin.cells[static_cast<std::size_t>(cell)];
      const auto at = [&](std::size_t i) { return beyond[static_cast<std::size_t>(nodes.at(i))]; };
      if ((at(0) & at(1) & at(2) & at(3)) == 0 && (shape_ == nullptr || near_shape(side(s).box(cell)))) {
        for (const Index place : nodes) {
          chosen[static_cast<std::size_t>(place)] = 1;
        }
      }
    }
    sent_.at(s).clear();
    std::ranges::copy_if(own_.at(s), std::back_inserter(sent_.at(s)),
                         [&](const SkinNode& node) { return chosen[static_cast<std::size_t>(node.place)] != 0; });
  }
}

/// For each node, a bit for each side of the zone that it lies beyond: a cell whose nodes have one in common is
/// outside.
std::vector<std::uint8_t> Meeting::sides_beyond(std::size_t s, const Box& zone) const {
  std::vector<std::uint8_t> beyond(side(s).skin.nodes.size());
  const bool half_space = shape_ != nullptr && shape_->planes.size() == 1;
  for (const SkinNode& node : here_.at(s)) {
    const auto place = static_cast<std::size_t>(node.place);
    const Vector3& x = side(s).position[place];
    unsigned sides = half_space && shape_->planes[0].distance(x) > margin_ ? 1U : 0U;
    for (int axis = 0; axis < 3; ++axis) {
      sides |= (x[axis] < zone.min()[axis] ? 2U : 0U) << 2 * axis;
      sides |= (x[axis] > zone.max()[axis] ? 4U : 0U) << 2 * axis;
    }
    beyond[place] = static_cast<std::uint8_t>(sides);
  }
  return beyond;
}

void Meeting::gather_cells(const Whereabouts& whole) {
  for (std::size_t s = 0; s < sides_; ++s) {
    std::vector<char> known(side(s).skin.nodes.size());
    for (const SkinNode& node : sent_.at(s)) {
      known[static_cast<std::size_t>(node.place)] = 1;
    }
    for (const Peer& peer : peers_) {
      for (const Index place : peer.nodes.at(s)) {
        known[static_cast<std::size_t>(place)] = 1;
      }
    }
    cells_.at(s).clear();
    const auto& cells = side(s).skin.cells;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      if (std::ranges::all_of(cells[cell], [&](Index place) { return known[static_cast<std::size_t>(place)] != 0; })) {
        cells_.at(s).push_back(static_cast<Index>(cell));
      }
    }
  }
  if (shape_ != nullptr) {
    cells_[1].clear();
    for (std::size_t p = 0; p < shape_->boxes.size(); ++p) {
      if (near_part(whole.boxes[0], p)) {
        cells_[1].push_back(static_cast<Index>(p));
      }
    }
  }
}

bool Meeting::speaks() const {
  return near_ && std::ranges::none_of(peers_, [&](const Peer& peer) { return peer.near && peer.rank < rank_; });
}

}  // namespace idiophone::contact
