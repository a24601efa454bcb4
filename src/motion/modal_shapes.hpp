#pragma once
// Mode shapes in packs of eight nodes: what the modes do to nodes, and what forces on nodes do to the modes.

#include <array>
#include <span>
#include <vector>

#include "idiophone/motion/modal_basis.hpp"
#include "idiophone/solid/pack.hpp"

namespace idiophone::motion {

using solid::Pack;

/// A vector for each of eight nodes.
using PackVector = std::array<Pack, 3>;

class ModalShapes {
 public:
  ModalShapes() = default;
  explicit ModalShapes(const ModalBasis& basis);

  [[nodiscard]] std::size_t packs() const { return packs_; }
  [[nodiscard]] std::size_t modes() const { return modes_; }

  /// How far and how fast the modes move eight nodes.
  struct Vibration {
    PackVector displacement = {};  ///< m
    PackVector velocity = {};      ///< m/s
  };
  /// @param places, rates  [modes] kg^1/2 m, kg^1/2 m/s
  [[nodiscard]] Vibration vibration(std::size_t pack, std::span<const double> places,
                                    std::span<const double> rates) const;

  /// Adds the products of the shapes with forces on eight nodes, node by node.
  /// @param sums  [modes]
  void add_products(std::size_t pack, const PackVector& force, std::span<Pack> sums) const;

  /// What mode k does to a node, kg^-1/2.
  [[nodiscard]] Vector3 at(std::size_t mode, std::size_t node) const;

 private:
  std::size_t modes_ = 0;
  std::size_t packs_ = 0;
  std::vector<PackVector> shapes_;  ///< [packs x modes]
};

}  // namespace idiophone::motion
