#pragma once
// The force of the air on the surface. It is known once in an interval of several steps.

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/motion/loaded_triangles.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::motion {

/// The normal velocity is linear on each triangle, with values at its corners. With V the mean of one of them in the
/// last interval and v now, the force of the air that works on it is force + resistance (v - V), inwards. The nodes of
/// the element's face get the force by the matrix that gives v of their velocities, transposed. In the step where an
/// interval begins, the mean of this and of what acted before it acts: then the work in an interval is that of its
/// force along the way of the surface. A node gets the same force on any number of ranks.
class SurfaceLoad {
 public:
  /// @param triangles  as loaded_triangles()
  /// @param reference  [local nodes] m; must outlive this object
  /// @param interval   s
  SurfaceLoad(LoadedTriangles triangles, std::span<const Vector3> reference, double interval);

  [[nodiscard]] const LoadedTriangles& triangles() const { return triangles_; }
  /// Of the triangles' faces, local numbers, ascending: the nodes that are read here, and that feel a force.
  [[nodiscard]] std::span<const Index> nodes() const { return nodes_; }

  /// Begins, with the velocities of now as those of the last interval, and without a force.
  /// @param state  [local nodes], ghosts too, as everywhere here
  void start(std::span<const solid::NodeState> state);

  /// Ends an interval.
  /// @param changes  [triangles x 3 corners] of the mean normal velocity since the interval before, m/s: the volume
  ///                 that a triangle swept is exact
  void end_interval(std::span<const solid::NodeState> state, std::span<double> changes);

  /// To be filled between the end of an interval and the beginning of the next, [triangles x 3 corners], N.
  [[nodiscard]] std::span<double> force() { return force_; }
  /// Likewise, N s/m.
  [[nodiscard]] std::span<double> resistance() { return resistance_; }

  void begin_interval(std::span<const solid::NodeState> state);

  /// To be called after each step that does not end an interval.
  void go_on() { now_ = whole_; }

  /// Adds the forces on the nodes, N.
  /// @param force  [local nodes]; meaningless at ghosts
  void add(std::span<const solid::NodeState> state, std::span<solid::NodeForce> force) const;

  /// Between two intervals. Collective.
  /// @param triangles  the rows that these triangles are
  /// @param state      at this moment
  void archive(parallel::Archive& archive, const parallel::Rows& triangles, std::span<const solid::NodeState> state);

 private:
  /// On the value at a corner, inwards: constant + resistance v.
  struct LinearForce {
    double constant = 0.0;    ///< N
    double resistance = 0.0;  ///< N s/m
  };
  [[nodiscard]] const std::vector<LoadedTriangle>& loaded() const { return triangles_.triangles; }
  void find_geometry(std::span<const solid::NodeState> state);

  LoadedTriangles triangles_;
  std::vector<Index> nodes_;
  std::span<const Vector3> reference_;
  double interval_;
  std::vector<Vector3> normal_;  // outwards, at the beginning of the interval
  // [triangles x 3 corners]
  std::vector<double> displaced_;  // along the normal then, m
  std::vector<double> velocity_;   // V, m/s
  std::vector<double> force_, resistance_;
  std::vector<LinearForce> whole_, now_;  // in this interval, and in this step
};

}  // namespace idiophone::motion
