#pragma once
// The kernels of finite elements, compiled for an accelerator and for one type of element.

#include "idiophone/foundation/accelerator/kernel.hpp"
#include "idiophone/foundation/element/type.hpp"

namespace idiophone::accelerated {

/// What the law of a body needs.
struct LawSize {
  bool has_rates = false;  ///< whether any material damps
  int mechanisms = 0;      ///< most relaxations of a material
};

/// Numbers of a material in the table of all: stiffness (6 x 6, Pa), stress where the body rests (6, Pa), and its law.
/// The law has two numbers, then keep and gain of each mechanism (solid::Memory). The two are the modulus at frequency
/// 0 and the damping of a material with a memory, or 0 and beta (s) of one without.
inline constexpr int law_in_material = 42;
[[nodiscard]] constexpr int material_length(const LawSize& law) {
  return law_in_material + 2 + 2 * law.mechanisms;
}

/// Functions of src/solids/accelerated/kernels, by name.
struct SolidKernels {
  SolidKernels(accelerator::Accelerator& accelerator, element::Type type, const LawSize& law);

  accelerator::Program program;
  accelerator::Kernel stress_points;
  accelerator::Kernel advance_nodes, push_nodes, displace_nodes, gather_motion, scatter_motion;
};

}  // namespace idiophone::accelerated
