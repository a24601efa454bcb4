#pragma once
// The mass that selective mass scaling adds to the relative motion of the nodes of through-thickness columns.
//
// A column's nodes have masses m_i and heights z_i above its centre of mass. Its linear shape is v = z, its quadratic
// one v = z^2, made orthogonal to 1 and z under the masses. With w_i = m_i v_i/sqrt(sum m v^2), each shape has a vector
// D = sum w_i x_i, whose kinetic energy without scaling is D'^2/2. Scaling adds
//   b D'^2/2 + c (d(n . D)/dt)^2/2,  n = D_linear/|D_linear| the current director,
// with b of rotation or plane bow, and b + c of stretch or bow. The first part is linear. The second is that of two
// scalars, the column's length and its bow, which no rotation changes: it exerts no torque, and it needs the terms that
// are quadratic in the velocities (the column's centripetal acceleration is no stretching).

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/mesh/part.hpp"
#include "idiophone/solid/mass_scaling.hpp"
#include "idiophone/solid/node.hpp"

namespace idiophone::solid {

class AddedMass {
 public:
  /// None.
  AddedMass() = default;

  /// @param body       of hexahedra, one layer of them along xi_3
  /// @param reference  [local nodes] X, m
  /// @param lumped     [owned nodes of the body] kg
  /// @param held       [owned nodes of the body] 1 where a component is held: a column with such a node is left as it
  /// is
  /// @param scaling    of a column of so many metres
  /// @throws std::runtime_error where columns of two elements share some of their nodes only
  AddedMass(const mesh::BodyPart& body, std::span<const Vector3> reference, std::span<const double> lumped,
            std::span<const char> held, const std::function<MassScaling(double)>& scaling);

  /// Whether an owned node has added mass.
  [[nodiscard]] bool has(Index node) const { return !has_.empty() && has_[node - begin_] != 0; }

  /// Calls visit(node, acceleration, m/s2) for the nodes that have added mass.
  /// @param state  [local nodes]
  /// @param force  [local nodes] N
  template <class Visitor>
  void solve(const NodeState* state, const NodeForce* force, Visitor visit) const {
    for (const Column& column : columns_) {
      const std::array<Vector3, 2> change = acceleration_change(column, state, force);
      for (const Member& member : members(column)) {
        const auto& f = force[member.node].component;
        visit(member.node, Vector3(member.inverse_mass * (Vector3(f[0], f[1], f[2]) + member.weight[0] * change[0] +
                                                          member.weight[1] * change[1])));
      }
    }
  }

  /// Calls visit(node, momentum beyond the lumped mass's, kg m/s) for the nodes that have added mass.
  /// @param velocity  [owned nodes of all bodies] m/s
  template <class Visitor>
  void multiply(const NodeState* state, std::span<const Vector3> velocity, Visitor visit) const {
    for (const Column& column : columns_) {
      const std::array<Vector3, 2> added = momentum(column, state, velocity);
      for (const Member& member : members(column)) {
        visit(member.node, Vector3(member.weight[0] * added[0] + member.weight[1] * added[1]));
      }
    }
  }

  /// x becomes (1 - R) x, with (1 - R)^2 the inverse of the scaled mass over the lumped one of the undeformed body, in
  /// coordinates in which the lumped mass is 1. R is symmetric. [3 x owned nodes of the body]
  void apply_inverse_root(std::span<double> x) const;

  /// Calls visit(row, column, entry in kg), for the undeformed body; components are 3 node + axis.
  template <class Visitor>
  void for_each_entry(Visitor visit) const {
    for (const Column& column : columns_) {
      for (const Member& row : members(column)) {
        for (const Member& other : members(column)) {
          const Eigen::Matrix3d block = entries(column, row, other);
          for (Index i = 0; i < 3; ++i) {
            for (Index j = 0; j < 3; ++j) {
              visit(3 * row.node + i, 3 * other.node + j, block(i, j));
            }
          }
        }
      }
    }
  }

  /// Nodes of the longest column; 1 if there is none.
  [[nodiscard]] int longest() const;

 private:
  /// A node of a column.
  struct Member {
    Index node;
    double inverse_mass;           ///< 1/kg
    std::array<double, 2> weight;  ///< w of the linear and of the quadratic shape, kg^1/2
  };
  struct Column {
    std::size_t first;  ///< in members_
    std::size_t count;
    std::array<Vector3, 2> spread;    ///< D of the undeformed column, kg^1/2 m
    std::array<double, 2> isotropic;  ///< b of each shape
    std::array<double, 2> along;      ///< c of each shape
  };
  struct Pose;

  void add_column(std::span<const Index> nodes, std::span<const Vector3> reference, std::span<const double> lumped,
                  const std::function<MassScaling(double)>& scaling);
  [[nodiscard]] std::span<const Member> members(const Column& column) const {
    return std::span(members_).subspan(column.first, column.count);
  }
  /// Of each shape's vector, beyond that without added mass.
  [[nodiscard]] std::array<Vector3, 2> acceleration_change(const Column& column, const NodeState* state,
                                                           const NodeForce* force) const;
  /// Of each shape's vector, beyond that without added mass.
  [[nodiscard]] std::array<Vector3, 2> momentum(const Column& column, const NodeState* state,
                                                std::span<const Vector3> velocity) const;
  [[nodiscard]] static Eigen::Matrix3d entries(const Column& column, const Member& row, const Member& other);
  [[nodiscard]] Pose pose(const Column& column, const NodeState* state) const;

  Index begin_ = 0;        ///< the body's first owned node
  std::vector<char> has_;  ///< [owned nodes of the body]
  std::vector<Column> columns_;
  std::vector<Member> members_;
};

}  // namespace idiophone::solid
