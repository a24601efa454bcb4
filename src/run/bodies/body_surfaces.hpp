#pragma once
// This rank's share of the surfaces of all bodies, whichever model moves them: from the motion's states at each read to
// the surface's motion at each audio sample.

#include <mpi.h>

#include <span>
#include <vector>

#include "finite_element_surfaces.hpp"
#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "modal_surface.hpp"

namespace idiophone::bodies {

class BodySurfaces {
 public:
  /// Collective.
  /// @param ready    must outlive this object
  /// @param surface  of all bodies
  BodySurfaces(const Preparation& ready, const propagation::AudibleSurface& surface, MPI_Comm communicator);

  [[nodiscard]] const surface::Sampling& sampling() const { return finite_elements_.sampling(); }

  /// From now on, an accelerator computes the surfaces of finite elements, as it does their motion.
  void accelerate(accelerator::Accelerator& accelerator, const motion::Motion& motion) {
    finite_elements_.accelerate(accelerator, motion);
  }

  /// Begins at time 0. The surfaces are taken to have moved with their velocities for ever.
  void start(const motion::Motion& motion, surface::SurfaceMotion& result);

  /// Takes the motion at the end of one more read.
  void read(motion::Motion& motion);

  /// Ends an audio sample; what belongs to which: see surface::Surface.
  void take(surface::SurfaceMotion& result);

  /// Of a modal body so far, m; zero on ranks that do not have it.
  [[nodiscard]] double largest_vibration(std::size_t body) const;

  /// Likewise, root mean square of the rotation angles in a modal body with large amplitudes, rad.
  [[nodiscard]] double largest_rotation(std::size_t body) const;

  /// All that decides the future. Collective.
  void archive(parallel::Archive& archive);

 private:
  /// Neighbours in the rank's share.
  struct Range {
    std::size_t first;
    std::size_t count;
  };
  /// A modal body on this rank, whose triangles and vertices are neighbours.
  struct ModalBody {
    std::size_t number;  ///< of the body
    Range triangles;
    Range vertices;
    ModalSurface surface;

    [[nodiscard]] std::span<double> pressure(surface::SurfaceMotion& motion) const {
      return std::span(motion.pressure).subspan(triangles.first, triangles.count);
    }
    [[nodiscard]] std::span<double> position(surface::SurfaceMotion& motion) const {
      return std::span(motion.position).subspan(3 * vertices.first, 3 * vertices.count);
    }
  };

  void add_modal_body(std::size_t body, const modal_bodies::ModalBasis& basis);

  const Preparation& ready_;
  MPI_Comm communicator_;
  FiniteElementSurfaces finite_elements_;
  std::vector<ModalBody> modal_;
};

}  // namespace idiophone::bodies
