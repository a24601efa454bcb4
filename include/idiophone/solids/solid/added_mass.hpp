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
#include <map>
#include <span>
#include <vector>

#include "idiophone/foundation/element/type.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/mass_scaling.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/pack.hpp"

namespace idiophone::solid {

/// Columns are stored and computed in packs. All have the same number of nodes: those of one line of nodes
/// through the thickness of an element.
class AddedMass {
 public:
  /// None.
  AddedMass() = default;

  /// @param body       of hexahedra, one layer of them along xi_3
  /// @param reference  [local nodes] X, m
  /// @param lumped     [owned nodes of the body] kg
  /// @param held       owned components of the body that are held, 3 node + axis, ascending; a column all of whose
  /// components are held is left as it is
  /// @param scaling    of a column of so many metres
  /// @throws std::runtime_error where columns of two elements share some of their nodes only
  AddedMass(const mesh::BodyPart& body, std::span<const Vector3> reference, std::span<const double> lumped,
            std::span<const Index> held, const std::function<MassScaling(double)>& scaling);

  /// Turns forces into those that give the lumped mass the accelerations of the scaled one: f becomes M_lumped a.
  /// @param state  [local nodes]
  /// @param age    how much older the velocities are than the displacements, s: half a step
  /// @param force  [local nodes] N
  void reduce_to_lumped(std::span<const NodeState> state, double age, std::span<NodeForce> force) const;

  /// Adds the momentum beyond the lumped mass's, kg m/s.
  /// @param velocity  [owned nodes of all bodies] m/s
  /// @param momentum  [owned nodes of the body]
  void add_momentum(std::span<const NodeState> state, std::span<const Vector3> velocity,
                    std::span<Vector3> momentum) const;

  /// Gives the held components of columns with added mass their velocities, by the impulses that this takes; the
  /// columns' free components move along.
  /// @param velocities  [held components] m/s
  /// @param state       [local nodes] velocities are changed
  /// @param impulses    [held components] N s, to which those on columns with added mass are added; may be empty
  void impose(std::span<const double> velocities, std::span<NodeState> state, std::span<double> impulses) const;

  /// What each column adds to the second moment of mass, the sum of m x x^T, of the body in its present pose: sum of
  /// b D D^T. The stretch and the bow add nothing, as no rotation changes them. [columns] kg m2
  [[nodiscard]] std::vector<Eigen::Matrix3d> second_moments(std::span<const NodeState> state) const;

  /// x becomes (1 - R) x, with (1 - R)^2 the inverse of the scaled mass over the lumped one of the undeformed body, in
  /// coordinates in which the lumped mass is 1. R is symmetric. Where components of a column are held, they become 0,
  /// and the inverse is that of the free components' mass. [3 x owned nodes of the body]
  void apply_inverse_root(std::span<double> x) const;

  /// Calls visit(row, column, entry in kg), for the undeformed body; components are 3 node + axis.
  template <class Visitor>
  void for_each_entry(Visitor visit) const {
    for (std::size_t c = 0; c < column_count_; ++c) {
      const Column column = at(c);
      for (const ColumnNode& row : column.members) {
        for (const ColumnNode& other : column.members) {
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

  /// Nodes of a column; 1 if there is none.
  [[nodiscard]] int column_length() const { return column_count_ == 0 ? 1 : static_cast<int>(levels_); }

 private:
  /// A node of a column.
  struct ColumnNode {
    Index node;
    double inverse_mass;           ///< 1/kg
    std::array<double, 2> weight;  ///< w of the linear and of the quadratic shape, kg^1/2
  };
  struct Column {
    std::vector<ColumnNode> members;
    std::array<Vector3, 2> spread;    ///< D of the undeformed column, kg^1/2 m
    std::array<double, 2> isotropic;  ///< b of each shape
    std::array<double, 2> along;      ///< c of each shape
  };

  /// A column with held and free components.
  struct HeldColumn {
    Column column;
    std::vector<int> held;           ///< 3 level + axis
    std::vector<int> free;           ///< likewise
    std::vector<std::size_t> place;  ///< of the held components among the body's
    Eigen::MatrixXd inverse_root;    ///< of the free components' mass over the lumped one
  };

  /// The nodes of a pack of columns at one level of the thickness.
  struct Level {
    Pack inverse_mass;  ///< 1/kg
    Pack weight[2];     ///< as ColumnNode's
    Index node[lanes];
  };
  /// A pack of columns: what Column has but for the members, whose levels are in level_.
  struct ColumnPack {
    Pack spread[2][3];
    Pack isotropic[2];
    Pack compliance[2];  ///< 1/(1 + b)
    Pack along[2];
  };
  struct Sums;
  static constexpr std::size_t most_levels = element::highest_hex_order + 1;

  /// @param masses  of the nodes, kg
  [[nodiscard]] static Column make_column(std::span<const Index> nodes, std::span<const Vector3> reference,
                                          std::span<const double> masses,
                                          const std::function<MassScaling(double)>& scaling);
  void add(const Column& column);
  [[nodiscard]] Column at(std::size_t column) const;
  /// Columns in a pack; the last pack is padded with copies of one of its columns.
  [[nodiscard]] int filled_lanes(std::size_t pack) const {
    return static_cast<int>(std::min<std::size_t>(lanes, column_count_ - pack * lanes));
  }
  [[nodiscard]] std::span<const Level> levels(std::size_t pack) const {
    return std::span(level_).subspan(pack * levels_, levels_);
  }
  /// The acceleration of each shape's D beyond that without added mass.
  static void find_change(const ColumnPack& pack, const Sums& sums, double age, Pack (&change)[2][3]);
  void put_forces(std::size_t pack, const Pack (*forces)[3], std::span<NodeForce> force) const;
  [[nodiscard]] Sums sums_of_positions(std::size_t pack, std::span<const NodeState> state) const;
  void add_held(std::size_t number, const Column& column, std::span<const Index> held);
  void apply_held_root(const HeldColumn& held, std::span<double> x) const;
  [[nodiscard]] static Eigen::Matrix3d entries(const Column& column, const ColumnNode& row, const ColumnNode& other);

  Index begin_ = 0;         ///< the body's first owned node
  std::size_t levels_ = 0;  ///< nodes of a column
  std::size_t column_count_ = 0;
  std::vector<ColumnPack> packs_;
  std::vector<Level> level_;                ///< [levels x packs]
  std::map<std::size_t, HeldColumn> held_;  ///< by the number of the column
};

}  // namespace idiophone::solid
