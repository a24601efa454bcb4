#pragma once
// Groups held still, as hinges are, or driven along a prescribed path, component by component.

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/motion/attachments.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "idiophone/solids/solid/mass.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::motion {

class Constraints {
 public:
  /// A component in a fixed and in a driven group is driven; in two driven groups, it follows the last in the deck.
  Constraints(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments);

  /// Puts the held components of the owned nodes where they are at `time` (s), at rest there.
  void place(double time, std::span<solid::NodeState> state) const;

  /// Replaces the velocities of a body's held components by those that lead to their places at the end of the step.
  /// @param mass  of the body
  /// @param work  what the driven groups do in this step is added, J
  void steer(std::size_t body, const Step& step, const solid::Mass& mass, std::span<solid::NodeState> state,
             ReproducibleSum& work) const;

  /// Owned components of a body that are held, as 3 node + axis in local numbers, ascending.
  [[nodiscard]] std::span<const Index> held_components(std::size_t body) const { return bodies_[body].components; }

  /// Those of all bodies, ascending.
  [[nodiscard]] std::vector<Index> held_components() const;

 private:
  /// A rigid motion: the node at X in the reference is displaced by turn (X - pivot) + shift.
  struct RigidMotion {
    Eigen::Matrix3d turn;  ///< rotation matrix minus identity
    Vector3 pivot;         ///< m
    Vector3 shift;         ///< m
  };
  struct Group {
    std::vector<Index> nodes;
    std::vector<Vector3> reference;  ///< [nodes], m
    scene::DrivenGroup path;         ///< without displacement and rotation where the group is fixed
    std::vector<Index> places;       ///< [held components] place among the body's; -1 if a later group holds it

    /// Position(t) = pivot + R(s(t) rotation) (X - pivot) + s(t) displacement, s the signal.
    [[nodiscard]] RigidMotion at(double time) const;
  };

  /// What is held of one body.
  struct Held {
    std::vector<Group> groups;
    std::vector<Index> components;  ///< owned, 3 node + axis in local numbers, ascending, each once
    std::vector<double> at_rest;    ///< [components] m/s, zero
  };

  static Group group(const scene::DrivenGroup& path, const mesh::Patch& patch, const mesh::Part& part);
  static void number_components(Held& held);

  /// Adds what a moving group does in a step: the impulses that it gives times the mean of the old and new velocities.
  /// @param before      the time one step ago, s
  /// @param velocities  new ones of the body's held components, m/s
  /// @param impulses    on them, N s
  static void add_work(const Group& group, double before, double step, std::span<const solid::NodeState> state,
                       std::span<const double> velocities, std::span<const double> impulses, ReproducibleSum& work);

  /// Calls visit(node, axis, displacement in m at that time) for each held component of a group.
  template <class Visitor>
  static void for_each_component(const Group& group, double time, Visitor visit);

  std::vector<Held> bodies_;  ///< [bodies]
};

}  // namespace idiophone::motion
