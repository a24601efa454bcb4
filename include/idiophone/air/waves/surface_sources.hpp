#pragma once
// Surfaces that move the air: what their velocities add to the nodes next to them, and the force of the air on them.

#include <span>
#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"
#include "idiophone/air/waves/wave_field.hpp"

namespace idiophone::waves {

/// The force of the air on a triangle: the part of it that one node exerts.
struct ForceShare {
  Index triangle = 0;
  std::array<int, 3> cell{};  ///< of the node
  double force = 0.0;         ///< the integral of the pressure, N; it acts against the normal
  double resistance = 0.0;    ///< by how much half a step with a velocity along the normal raises the force, over rho c
                              ///< times this velocity, m2: for a surface that moves as a whole
};

/// The largest resistance of a share, over its area: half a step where the volume of a part is the least that its open
/// areas allow, and these are not smaller than its surface. Pockets narrower than a cell can have more.
/// @param courant  c dt/h
[[nodiscard]] constexpr double largest_resistance(double courant) {
  return courant / 2.0 / least_volume(courant);
}

/// The integral of the normal velocity over a surface, piece by piece, each piece to the node in front of it.
class SurfaceSources {
 public:
  SurfaceSources() = default;
  /// @param moving      triangles that may move: the first ones of the obstruction
  /// @param cut_cells   of the obstruction
  /// @param courant     c dt/h
  SurfaceSources(const Subdomain& subdomain, const Obstruction& obstruction, std::size_t moving,
                 const CutCells& cut_cells, double courant);

  /// A node's rate gains rho c^2 dt/V times the change of the volume flow out of the surface. With the plane wave's
  /// pressure rho c v_n in place of the velocity, that is C (area/h^2)/(V/h^3) times its change.
  /// @param change   [moving] of rho c v_n in a step, Pa
  /// @param sources  [nodes] overwritten, Pa per step
  void add(std::span<const float> change, std::span<float> sources) const;

  /// The integrals of these pressures, in which the pieces are those of add(): what add() gives to the air is the work
  /// of these forces.
  /// @param pressure  [nodes] Pa
  /// @return by triangle, then by node; valid until the next call
  [[nodiscard]] const std::vector<ForceShare>& forces(std::span<const float> pressure);

  /// Area of triangles that have no air in front of them, m2: surfaces that touch.
  [[nodiscard]] double covered_area() const { return covered_area_; }

  /// A part of a triangle.
  struct Piece {
    Index node, triangle;
    float weight;  ///< of its pressure
  };
  /// Of which add() is the sum: by node, then by triangle.
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  /// The area of a triangle in front of which a node is.
  struct Front {
    Index node;
    float area;  ///< m2
  };
  void add_triangle(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                    const CutCells& cut_cells);
  void find_fronts(std::vector<Piece> areas, const CutCells& cut_cells);
  void find_resistances(std::size_t nodes);

  std::vector<Piece> pieces_;       // by node, then by triangle; first the area, then the weight
  std::vector<Front> fronts_;       // by triangle, then by node
  std::vector<ForceShare> shares_;  // [fronts]
  double covered_area_ = 0.0;
};

}  // namespace idiophone::waves
