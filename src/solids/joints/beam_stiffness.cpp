#include "idiophone/solids/joints/beam_stiffness.hpp"

namespace idiophone::joints {

BeamStiffness beam_stiffness(const scene::Shank& shank, double length) {
  const double nu = shank.poisson, pull = shank.preload;
  const double area = shank.section();
  const double inertia = area * shank.radius * shank.radius / 4;  // I, m4
  const double shear = shank.young / (2 * (1 + nu));              // G, Pa
  const double shear_area = 6 * (1 + nu) / (7 + 6 * nu) * area;
  const double bending = shank.young * inertia / length;
  const double phi = 12 * bending / (shear * shear_area * length);
  return {.axial = shank.young * area / length,
          .lateral = 12 * bending / ((1 + phi) * length * length) + 1.2 * pull / length,
          .bending = bending + pull * length / 12,
          .torsion = 2 * shear * inertia / length};
}

}  // namespace idiophone::joints
