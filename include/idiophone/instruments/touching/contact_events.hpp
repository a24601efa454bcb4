#pragma once
// Contacts as physics engines report them. Only the standard library is needed.

#include <array>
#include <cstddef>
#include <cstdint>

namespace idiophone::touching {

/// x, y, z
using Triple = std::array<double, 3>;

/// One side of a contact: its material, its shape where it touches, and its roughness.
struct Surface {
  double young = 2e11;     ///< Young's modulus, Pa
  double poisson = 0.3;    ///< Poisson's ratio
  double radius = 0.01;    ///< of curvature, m
  double height = 1e-6;    ///< of the roughness, root of the mean square, m
  double exponent = 1.0;   ///< the power of the roughness falls as 1/frequency^exponent
  double longest = 5e-3;   ///< wavelength of the roughness, m
  double shortest = 2e-5;  ///< likewise
  double friction = 0.3;   ///< coefficient
};

/// What a contact did in a step of the physics.
struct ContactEvent {
  /// The impulse of an `end` is left out. `begin` and `persist` mean the same: impulses tell them apart.
  enum class Phase : std::int32_t { begin, persist, end };
  static constexpr std::int32_t nobody = -1;  ///< a side that makes no sound, such as the ground
  static constexpr double unknown = -1.0;

  std::uint64_t contact = 0;  ///< a number that stays the same while the same two bodies touch at the same place
  Phase phase = Phase::begin;
  std::array<std::int32_t, 2> bodies = {0, nobody};  ///< numbers of the stage
  std::array<std::int32_t, 2> surfaces = {0, 0};     ///< numbers of the stage, of both sides
  Triple point{};                                    ///< in the world, m
  Triple normal = {0, 0, 1};                         ///< unit vector: of the force on the first body
  double impulse = 0.0;                              ///< along the normal in this step, N s; not negative
  Triple slip{};            ///< velocity of the first body over the second along the surface, m/s
  double roll = 0.0;        ///< speed at which the point of contact goes along the surfaces, m/s
  double mass = unknown;    ///< that the impulse moves, at least 1e-9 kg; unknown: from the masses of the bodies
  double moment = unknown;  ///< of an impact in the step, 0 to 1; unknown: any
};

}  // namespace idiophone::touching
