#pragma once
// This rank's share of the surfaces of bodies that finite elements move, read on the processor or on an accelerator.

#include <optional>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/surface/accelerated_surface.hpp"
#include "idiophone/air/surface/surface.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "surface_share.hpp"

namespace idiophone::bodies {

/// Its functions are those of BodySurfaces, for these bodies.
class FiniteElementSurfaces {
 public:
  /// Collective.
  /// @param ready     must outlive this object
  /// @param surface   of all bodies
  /// @param left_out  [bodies] those that something else moves
  FiniteElementSurfaces(const Preparation& ready, const propagation::AudibleSurface& surface,
                        const std::vector<bool>& left_out, MPI_Comm communicator);

  [[nodiscard]] const surface::Sampling& sampling() const { return surface_.sampling(); }

  void accelerate(accelerator::Accelerator& accelerator, const motion::Motion& motion);
  void start(const motion::Motion& motion, surface::SurfaceMotion& result);
  void read(motion::Motion& motion);
  void take(surface::SurfaceMotion& result);
  void archive(parallel::Archive& archive);

 private:
  /// Neighbouring vertices of a body that an accelerator steps.
  struct AcceleratedVertices {
    std::size_t body;
    std::size_t first;                ///< of the vertices of share_
    accelerator::Array<Index> nodes;  ///< of each, its place among the displacements of the body
  };

  /// A triangle of a fracture surface.
  struct FractureTriangle {
    std::size_t triangle;  ///< of share_
    std::size_t fracture;  ///< place in Dynamics::fractures
    std::size_t face;      ///< of the fracture's
  };

  void find_fracture_triangles();
  void open_broken_faces(const motion::Motion& motion);
  void read_displacements(const motion::Motion& motion);
  void put(surface::SurfaceMotion& result) const;

  const Preparation& ready_;
  SurfaceShare share_;
  std::vector<std::size_t> nodes_;  ///< of its vertices
  surface::Surface surface_;
  surface::SurfaceMotion motion_;
  std::optional<surface::AcceleratedSurface> accelerated_;  ///< takes the place of surface_
  std::vector<AcceleratedVertices> accelerated_vertices_;
  std::vector<FractureTriangle> fracture_triangles_;
  parallel::Rows triangle_rows_, vertex_rows_;  ///< of the archive
};

}  // namespace idiophone::bodies
