#pragma once
// The mass matrix M of one body. Other modules ask it what M does and do not assume one number a node: selective mass
// scaling couples the nodes of a through-thickness column along the column's current director (added_mass.hpp).

#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/added_mass.hpp"
#include "idiophone/solids/solid/leapfrog.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::solid {

/// M = M_lumped + added mass. The added mass resists no translation of a column, so that it has no weight, moves no
/// centre of mass, and leaves accelerations by gravity as they are; and v M v >= v M_lumped v for all v.
///
/// Nodes are local numbers, components 3 node + axis. A rank owns all nodes of a column or none (mesh::node_owners).
class Mass {
 public:
  /// @param lumped  [local nodes] what Solid::add_mass gives, kg
  Mass(const mesh::BodyPart& body, std::span<const double> lumped, AddedMass added = {});

  /// Lumped mass at an owned node, kg: its weight, its share of the body's mass and moments, and a lower bound of what
  /// a force at the node has to accelerate.
  [[nodiscard]] double lumped(Index node) const { return lumped_[node - begin_]; }

  /// [owned nodes of the body], kg
  [[nodiscard]] std::span<const double> lumped() const { return lumped_; }

  /// Calls visit(node, acceleration, m/s2) for each owned node: a = M^-1 f, and what the change of M takes.
  /// @param state  [local nodes] where the nodes are, from which the directors follow, and their velocities
  /// @param age    how much older the velocities are than the displacements, s: half a step
  /// @param force  [local nodes] N; changed where there is added mass
  template <class Visitor>
  void solve(std::span<const NodeState> state, double age, std::span<NodeForce> force, Visitor visit) const {
    added_.reduce_to_lumped(state, age, force);
    for (std::size_t i = 0; i < lumped_.size(); ++i) {
      const Index node = begin_ + static_cast<Index>(i);
      const auto& f = force[node].component;
      visit(node, Vector3(f[0] * inverse_[i], f[1] * inverse_[i], f[2] * inverse_[i]));
    }
  }

  /// v becomes keep v + gain (M^-1 f + gravity) at the owned nodes.
  /// @param age    as in `solve`
  /// @param force  [local nodes] N; changed where there is added mass
  /// @param state  [local nodes] velocities are changed
  void accelerate(const Kick& kick, double age, std::span<NodeForce> force, std::span<NodeState> state) const;

  /// Calls visit(node, momentum, kg m/s) for each owned node: p = M v.
  /// @param velocity  [owned nodes of all bodies] m/s
  template <class Visitor>
  void multiply(std::span<const NodeState> state, std::span<const Vector3> velocity, Visitor visit) const {
    std::vector<Vector3> momentum;
    for (std::size_t i = 0; i < lumped_.size(); ++i) {
      momentum.emplace_back(lumped_[i] * velocity[begin_ + i]);
    }
    added_.add_momentum(state, velocity, momentum);
    for (std::size_t i = 0; i < lumped_.size(); ++i) {
      visit(begin_ + static_cast<Index>(i), momentum[i]);
    }
  }

  /// What added mass makes the inertia of rotations larger by; see AddedMass::second_moments.
  [[nodiscard]] std::vector<Eigen::Matrix3d> added_second_moments(std::span<const NodeState> state) const {
    return added_.second_moments(state);
  }

  /// Gives held components their velocities by the impulses that this takes.
  /// @param components  all that are held, owned, ascending
  /// @param velocities  [components] m/s
  /// @param state       [local nodes] velocities are changed
  /// @param impulses    [components] N s, to which those of this change are added; may be empty
  void impose(std::span<const Index> components, std::span<const double> velocities, std::span<NodeState> state,
              std::span<double> impulses = {}) const;

  /// With L L^T = M^-1 of the undeformed body: x becomes L x, which takes the eigenvalues of K x = w^2 M x to those of
  /// L^T K L.
  /// @param x  [3 x owned nodes of the body]
  void apply_inverse_factor(std::span<double> x) const;

  /// x becomes L^T x.
  void apply_transposed_inverse_factor(std::span<double> x) const;

  /// The largest number of entries in a row of M.
  [[nodiscard]] int entries_per_row() const { return added_.column_length() > 1 ? 3 * added_.column_length() : 1; }

  /// Calls visit(row, column, entry in kg) for entries that add up to M of the undeformed body, in the rows of owned
  /// components.
  template <class Visitor>
  void for_each_entry(Visitor visit) const {
    for (std::size_t i = 0; i < 3 * lumped_.size(); ++i) {
      const Index component = 3 * begin_ + static_cast<Index>(i);
      visit(component, component, lumped_[i / 3]);
    }
    added_.for_each_entry(visit);
  }

 private:
  Index begin_;                       ///< the body's first owned node
  std::vector<double> lumped_;        ///< [owned nodes of the body], kg
  std::vector<double> inverse_;       ///< likewise, 1/kg
  std::vector<double> inverse_root_;  ///< likewise, kg^-1/2
  AddedMass added_;
};

}  // namespace idiophone::solid
