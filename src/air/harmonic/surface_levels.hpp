#pragma once
// A surface and its refinements, and solutions that are refined until the level of their sound no longer changes.

#include <deque>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"

namespace idiophone::harmonic {

/// A share of a vertex in the value at another place.
struct VertexShare {
  Index vertex = 0;
  double share = 0.0;
};

/// Each triangle as four, cut at the middles of its edges. The vertices keep their numbers; new ones follow. Triangle t
/// becomes the triangles 4 t to 4 t + 3, and the last of them has the middles of its edges.
struct RefinedBoundary {
  Boundary boundary;
  /// [new vertices] What a smooth field has there, by the values at old vertices: the quadratic function of the smooth
  /// surface that fits those of all triangles at both ends of the edge.
  std::vector<std::vector<VertexShare>> shares;
};

[[nodiscard]] RefinedBoundary refined(const Boundary& boundary);

/// A field of the old vertices, at all vertices of the refined surface.
/// @param velocity  [old vertices]
[[nodiscard]] std::vector<ComplexVector> at_vertices(const RefinedBoundary& fine,
                                                     const std::vector<ComplexVector>& velocity);

/// Surfaces, each finer than the one before.
class SurfaceLevels {
 public:
  /// @throws std::invalid_argument as BoundaryElements
  SurfaceLevels(const Boundary& boundary, const QuietAir& air, std::size_t most_vertices);

  [[nodiscard]] const BoundaryElements& coarsest() const { return levels_.front().elements; }

  struct Level {
    BoundaryElements elements;
    RefinedBoundary finer;  ///< the next one
  };
  /// @param number  0 for the coarsest, or one more than a level that there is
  /// @return none if it would have more vertices than are allowed
  [[nodiscard]] const Level* level(std::size_t number);

 private:
  std::size_t most_vertices_;
  std::deque<Level> levels_;
};

/// Outward, at the corners of each triangle, m/s: linear, with the volume flow of the quadratic motion between the
/// vertices. Linear interpolation would give a plate that twists a net motion that it does not have, and with it most
/// of its sound.
/// @param finer     refined(boundary)
/// @param velocity  [vertices] m/s
[[nodiscard]] std::vector<Complex> normal_velocity(const Boundary& boundary, const RefinedBoundary& finer,
                                                   const std::vector<ComplexVector>& velocity);

/// Several motions of one frequency.
struct RefinedSolution {
  const BoundaryElements* elements = nullptr;  ///< the finest that were needed
  std::size_t refinements = 0;                 ///< of the surface: the number of this level
  std::vector<BoundaryField> fields;           ///< [motions] on these
  std::vector<double> level_error;             ///< [motions] estimate, dB; NaN where the surface was not refined
};

/// Refines until the radiated power of all motions changes by no more than the tolerance. The last change is the
/// estimate of the error: errors fall by a factor of two or more, at edges of thin bodies and elsewhere.
/// @param velocities  [motions] of [coarsest vertices] m/s
[[nodiscard]] RefinedSolution solve_refined(SurfaceLevels& levels, double wave_number,
                                            std::vector<std::vector<ComplexVector>> velocities, double tolerance);

}  // namespace idiophone::harmonic
