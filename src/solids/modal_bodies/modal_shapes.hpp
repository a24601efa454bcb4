#pragma once
// Mode shapes at the nodes of a body: what forces on nodes do to the modes, and what the modes do to nodes.

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "idiophone/solids/solid/pack.hpp"

namespace idiophone::modal_bodies {

using solid::Pack;

/// A vector for each node of a pack.
using PackVector = std::array<Pack, 3>;

/// Of all nodes, node by node.
class ModalShapes {
 public:
  ModalShapes() = default;
  explicit ModalShapes(const ModalBasis& basis);

  [[nodiscard]] std::size_t modes() const { return static_cast<std::size_t>(rows_.rows()); }

  /// What mode k does to a node, kg^-1/2.
  [[nodiscard]] Vector3 at(std::size_t mode, std::size_t node) const;

  /// Adds the products of the shapes with a force on a node.
  /// @param sums  [modes]
  void add_products(std::size_t node, const Vector3& force, Eigen::ArrayXd& sums) const;

  /// Sums over the nodes of mass times the product of two modes. [modes x modes]
  /// @param masses  [nodes] kg
  [[nodiscard]] Eigen::MatrixXd mass_products(std::span<const double> masses) const;

 private:
  Eigen::ArrayXXd rows_;  ///< [modes x (3 x nodes)]: a column for each component of a node
};

/// Some nodes, in packs.
class NodeGroup {
 public:
  NodeGroup() = default;
  /// @param arms   [all nodes] X - C, m
  /// @param nodes  ascending numbers among all nodes
  NodeGroup(const ModalShapes& shapes, std::span<const Vector3> arms, std::vector<std::size_t> nodes);

  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }
  [[nodiscard]] std::size_t packs() const { return arms_.size(); }
  /// The nodes of a pack.
  [[nodiscard]] std::span<const std::size_t> nodes(std::size_t pack) const;
  /// X - C, m
  [[nodiscard]] const PackVector& arms(std::size_t pack) const { return arms_[pack]; }

  /// How far and how fast the modes move the nodes of a pack.
  struct Vibration {
    PackVector displacement = {};  ///< m
    PackVector velocity = {};      ///< m/s
  };
  /// @param places, rates  [modes] kg^1/2 m, kg^1/2 m/s
  [[nodiscard]] Vibration vibration(std::size_t pack, const Eigen::ArrayXd& places, const Eigen::ArrayXd& rates) const;

 private:
  std::size_t modes_ = 0;
  std::vector<std::size_t> nodes_;
  std::vector<PackVector> arms_;    ///< [packs]
  std::vector<PackVector> shapes_;  ///< [packs x modes]
};

}  // namespace idiophone::modal_bodies
