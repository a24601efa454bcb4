#pragma once
// The broad phase of a contact: which ranks, nodes and cells are so near the partner that they may touch it before the
// next update. It works with bounding boxes, which grow by a margin: the largest distance that nodes may travel.

#include <array>
#include <cstdint>
#include <vector>

#include "local_skin.hpp"
#include "side.hpp"

namespace idiophone::contact {

/// Where some nodes of both sides are, and how fast they move.
struct Bounds {
  std::array<Box, 2> boxes;  ///< empty where there is no node, m
  Box velocities;            ///< around their velocities, m/s
  double speed = 0.0;        ///< the largest, m/s

  void extend(const Bounds& other);
};

class BroadPhase {
 public:
  /// @param sides     one side, or two if the partners are two bodies
  /// @param shape     the other partner; null if that is a body: the same one, where there is one side
  /// @param interval  time between two updates, s
  BroadPhase(std::vector<Side*> sides, const RigidShape* shape, double interval);

  /// Sets the margin.
  /// @param whole  bounds of all nodes of both sides on all ranks
  void update(const Bounds& whole);

  /// Distance within which cells may touch until the next update, m.
  [[nodiscard]] double margin() const { return margin_; }

  /// Updates that may be left out after this one, because nothing can touch before: the partners are too far away, even
  /// if other forces make them faster by 5 m/s. The same on all ranks that have nodes of the partners.
  [[nodiscard]] int updates_to_skip() const;

  /// Whether any of the nodes within these bounds may touch the partner.
  [[nodiscard]] bool may_touch(const Bounds& part) const;

  /// Owned nodes of a side whose cells may touch the partner, ascending; all positions of the local skin are known.
  [[nodiscard]] std::vector<SkinNode> near_nodes(std::size_t side, const LocalSkin& skin) const;

  /// Convex parts of the shape that may be touched, ascending.
  [[nodiscard]] std::vector<Index> near_parts() const;

 private:
  [[nodiscard]] bool is_with_itself() const { return shape_ == nullptr && sides_.size() == 1; }
  /// How fast nodes of the partners may come nearer to each other, m/s, or more.
  [[nodiscard]] double closing_speed() const;
  /// Least distance between the partners, or less; m.
  [[nodiscard]] double gap() const;
  /// Largest distance of a box from the planes of a part, m: below zero if it is behind all of them.
  [[nodiscard]] double distance_to_planes(const Box& box, std::size_t part) const;
  [[nodiscard]] bool near_shape(const Box& box) const;
  [[nodiscard]] bool near_part(const Box& box, std::size_t part) const;
  [[nodiscard]] std::vector<std::uint8_t> sides_beyond(std::size_t side, const Box& zone, const LocalSkin& skin) const;

  std::vector<Side*> sides_;
  const RigidShape* shape_;
  double interval_;      ///< s
  double least_margin_;  ///< m
  Box shape_box_;        ///< around all of the shape, m
  double margin_ = 0.0;  ///< m
  Bounds whole_;
};

}  // namespace idiophone::contact
