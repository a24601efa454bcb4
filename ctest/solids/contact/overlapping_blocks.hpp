#pragma once
// Two blocks of random shape that overlap, as both sides of a contact.

#include <numeric>
#include <random>

#include "block_mesh.hpp"
#include "interaction.hpp"

namespace idiophone::contact {

/// A block's skin, every node put where `place` says.
struct Block {
  mesh::Mesh mesh;
  Skin skin;
  Side side;

  template <class Place>
  Block(element::Type element, const Vector3& size, const std::array<int, 3>& cells, Place place)
      : mesh(support::block_mesh(element, size, cells)), skin(make_skin(mesh, 0)), side(skin) {
    for (std::size_t i = 0; i < skin.nodes.size(); ++i) {
      side.position[i] = place(mesh.nodes[skin.nodes[i]]);
    }
  }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;

  [[nodiscard]] std::vector<Index> cells() const {
    std::vector<Index> all(skin.cells.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
};

/// Moves every node a little, so that nothing is regular.
class Shaker {
 public:
  explicit Shaker(double amplitude) : amount_(-amplitude, amplitude) {}
  Vector3 operator()(const Vector3& x) { return x + Vector3(amount_(random_), amount_(random_), amount_(random_)); }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> amount_;
};

/// Finds all overlaps where the sides are now, and the forces.
inline void compute(Interaction& interaction, BondUpdate bonds = BondUpdate::keep) {
  interaction.find_near_pairs();
  interaction.find_overlaps({});
  interaction.compute_forces(bonds);
}

}  // namespace idiophone::contact
