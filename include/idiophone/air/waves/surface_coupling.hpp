#pragma once
// Surfaces and air that act on each other: what the velocities of a surface add to the nodes next to it, and the force
// of the air on the surface.

#include <array>
#include <span>
#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"

namespace idiophone::waves {

/// The force of the air on a triangle: the part of it that one node exerts. Each corner has the integrals with its
/// linear shape function, which is 1 there and 0 at the other two.
struct ForceShare {
  Index triangle = 0;
  std::array<int, 3> cell{};           ///< of the node
  std::array<double, 3> force{};       ///< [corners] the integral of the pressure, N; it acts against the normal
  std::array<double, 3> resistance{};  ///< [corners] by how much half a step with a velocity along the normal raises
                                       ///< the force, over rho c times this velocity, m2: for a surface that moves as
                                       ///< a whole
};

/// The largest resistance of a share, over its area, all corners together: half a step where the volume of a part is
/// the least that its open areas allow, and these are not smaller than its surface. Pockets narrower than a cell can
/// have more.
/// @param courant  c dt/h
[[nodiscard]] constexpr double largest_resistance(double courant) {
  return courant / 2.0 / least_volume(courant);
}

/// The normal velocity is linear on each triangle. Its integral over each piece of a surface goes to the node in front
/// of the piece, whose pressure acts on the piece.
class SurfaceCoupling {
 public:
  SurfaceCoupling() = default;
  /// As SurfaceSources.
  SurfaceCoupling(const Subdomain& subdomain, const Obstruction& obstruction, std::size_t moving,
                  const CutCells& cut_cells, double courant);

  /// Does what SurfaceSources::add() does where all corners of a triangle have one velocity.
  /// @param change   [moving x 3 corners] of rho c v_n in a step, Pa
  /// @param sources  [nodes] overwritten, Pa per step
  void add(std::span<const float> change, std::span<float> sources) const;

  /// The integrals of these pressures, over the pieces of add(): what add() gives to the air is the work of these
  /// forces.
  /// @param pressure  [nodes] Pa
  /// @return by triangle, then by node; valid until the next call
  [[nodiscard]] const std::vector<ForceShare>& forces(std::span<const float> pressure);

 private:
  /// The area of a triangle in front of which a node is.
  struct Front {
    Index node;
    std::array<float, 3> areas;  ///< [corners] integral of the corner's shape function, m2
  };
  void add_triangle(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                    const CutCells& cut_cells);
  void find_resistances(std::size_t moving, std::size_t nodes);

  std::vector<Front> fronts_;       // by triangle, then by node
  std::vector<ForceShare> shares_;  // [fronts]
  std::vector<float> per_area_;     // [nodes] what a unit of area and of rho c v_n adds, 1/m2
};

}  // namespace idiophone::waves
