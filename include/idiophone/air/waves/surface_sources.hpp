#pragma once
// Surfaces that move the air: what their velocities add to the nodes next to them.

#include <span>
#include <vector>

#include "idiophone/air/waves/cut_cells.hpp"
#include "idiophone/air/waves/obstruction.hpp"
#include "idiophone/air/waves/subdomain.hpp"

namespace idiophone::waves {

/// The integral of the normal velocity over a surface, piece by piece, each piece to the node in front of it. A
/// triangle has one velocity. SurfaceCoupling is for surfaces that feel the air.
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

  /// A part of a triangle.
  struct Piece {
    Index node, triangle;
    float weight;  ///< of its pressure
  };
  /// Of which add() is the sum: by node, then by triangle.
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  void add_triangle(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                    const CutCells& cut_cells);

  std::vector<Piece> pieces_;  // by node, then by triangle; first the area, then the weight
};

}  // namespace idiophone::waves
