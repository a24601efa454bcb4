#pragma once
// A lattice that is being broken: tetrahedra, and what each of them has of the masses of its corners.

#include <array>
#include <vector>

#include "idiophone/instruments/proxies/fracture.hpp"

namespace idiophone::proxies {

/// Whether a mass has tetrahedra on both sides of the plane across a direction.
[[nodiscard]] bool can_split(const Lattice& lattice, const Overload& overload);

class Pieces {
 public:
  explicit Pieces(const Fragment& whole);

  /// The tetrahedra whose centres are ahead of a mass in a direction get a mass of their own.
  void split_mass(Index mass, const Vector3& direction);

  /// Two masses half-way between two, one for each half of the tetrahedra.
  void split_spring(Index a, Index b);

  /// Masses whose tetrahedra are not joined by faces around them become several, one for each group.
  void open_hinges();

  /// What hangs together.
  [[nodiscard]] std::vector<Fragment> fragments() const;

 private:
  [[nodiscard]] Index add_node(const Vector3& place, const Vector3& displacement, const Vector3& velocity, bool pinned);
  void restore_angular_momentum(const Vector3& before);
  [[nodiscard]] Vector3 angular_momentum() const;
  [[nodiscard]] Fragment fragment_of(const std::vector<std::size_t>& tetrahedra) const;

  const Lattice* whole_;
  std::vector<Vector3> nodes_, displacement_, velocity_;
  std::vector<bool> pinned_;
  std::vector<std::array<Index, 4>> tetrahedra_;
  std::vector<std::array<double, 4>> shares_;  // [tetrahedra] of the masses of its corners, kg
  std::vector<std::size_t> origin_;            // [tetrahedra] that it was in the whole
};

}  // namespace idiophone::proxies
