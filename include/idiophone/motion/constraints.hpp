#pragma once
// Groups held still, as hinges are, or driven along a prescribed path, component by component.

#include <vector>

#include "idiophone/motion/attachments.hpp"
#include "idiophone/parallel/reproducible_sum.hpp"
#include "idiophone/solid/node.hpp"

namespace idiophone::motion {

class Constraints {
 public:
  /// A component in a fixed and in a driven group is driven; in two driven groups, it follows the last in the deck.
  Constraints(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments);

  /// Puts the held components of the owned nodes where they are at `time` (s), at rest there.
  void place(double time, solid::NodeState* state) const;

  /// Replaces the held components' velocities by those that lead to their places one step later.
  /// @param arrival  the time of those places, s
  /// @param step     dt, s
  /// @param mass     [owned nodes], kg
  /// @param work     what the driven groups do in this step is added, J
  void steer(double arrival, double step, std::span<const double> mass, solid::NodeState* state,
             ReproducibleSum& work) const;

  /// Owned components that are held, as 3 node + axis in local numbers, ascending.
  [[nodiscard]] std::vector<Index> held_components() const;

 private:
  /// A rigid motion: the node at X in the reference is displaced by turn (X - pivot) + shift.
  struct Pose {
    Eigen::Matrix3d turn;  ///< rotation matrix minus identity
    Vector3 pivot;         ///< m
    Vector3 shift;         ///< m
  };
  struct Group {
    std::vector<Index> nodes;
    std::vector<Vector3> reference;  ///< [nodes], m
    scene::DrivenGroup path;         ///< without displacement and rotation where the group is fixed

    /// Position(t) = pivot + R(s(t) rotation) (X - pivot) + s(t) displacement, s the signal.
    [[nodiscard]] Pose at(double time) const;
  };

  void add(const scene::DrivenGroup& path, const mesh::Patch& patch, const mesh::Part& part);

  /// Calls visit(node, axis, displacement in m at that time) for each held component of a group.
  template <class Visitor>
  static void for_each_component(const Group& group, double time, Visitor visit);

  std::vector<Group> groups_;
};

}  // namespace idiophone::motion
