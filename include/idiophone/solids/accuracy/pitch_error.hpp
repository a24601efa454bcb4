#pragma once
// What a mesh does to the pitch of its body: rules of docs/use/mesh_guide.md, whose numbers come from
// verification/report.md.

#include <optional>
#include <string>

#include "idiophone/scene/body.hpp"
#include "idiophone/scene/material.hpp"
#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::accuracy {

/// Length of a bending wave, m, in a plate of a thickness (m) at a frequency (Hz). Its speed follows Kirchhoff's plate
/// while it is slow and approaches that of Rayleigh waves: c^-3 = (w^2 D/(rho h))^(-3/4) + c_R^-3, c_R = 0.93 c_shear.
[[nodiscard]] double bending_wavelength(const scene::Material& material, double thickness, double frequency);

/// Speed of waves of stretching in a thin plate, m/s; of an orthotropic material the smallest.
[[nodiscard]] double plate_speed(const scene::Material& material);

/// What the pitch of a body depends on, m.
struct Extents {
  Vector3 sides;     ///< Statistics::extents
  double thickness;  ///< of the wall; of a compact body its own: 1/t = area/(2 volume) - 1/length - 1/width
};

[[nodiscard]] Extents extents(const mesh::Statistics& mesh);

/// What the rules for waves and torsion do not hold for, if it is the body: "curved or joined thin walls"; none if they
/// hold. They know compact bodies, bars and flat walls of one material at rest. Curved and joined thin walls are more
/// than twice as high as they are thick; they keep less than the rules promise.
[[nodiscard]] std::optional<std::string> without_rules(const scene::Body& body, const mesh::Statistics& mesh);

/// The cells of a mesh. tet10 elements have the size of the cells that they were cut from.
struct Cells {
  element::Type type;
  double size;    ///< the longest in the plane, m
  double across;  ///< along the width, m
  double layer;   ///< through the thickness, m
};

[[nodiscard]] Cells cells_of(const mesh::Statistics& mesh, element::Type type);

/// Cents by which the partials of tet10 or hex near a frequency (Hz) may be wrong, within a factor of two and clamped
/// edges left aside: that of the slowest waves or, from the first mode of torsion on, of torsion if it is larger.
/// Waves:
/// - tet10: C (size/wavelength)^2, size no less than a layer. C is 2000 where elements are no longer than the part is
///   thick, and grows to 6500 where they are many times longer.
/// - hex of order p: A_p (2 size/wavelength)^(2p-2) in the plane and through the thickness; order 2 through the
///   thickness costs 1200 (layer/wavelength)^2. Infinite with less than two cells to a wavelength.
[[nodiscard]] double pitch_error(const Cells& cells, const Extents& body, const scene::Material& material,
                                 double frequency);

/// The highest frequency, Hz, up to which `pitch_error` stays below some cents.
[[nodiscard]] double highest_frequency(const Cells& cells, const Extents& body, const scene::Material& material,
                                       double cents);

/// What is wrong with a body's mesh, or nothing: elements that lock, or too long for the highest frequency (Hz) that is
/// to be heard.
[[nodiscard]] std::optional<std::string> mesh_warning(const mesh::Statistics& mesh, const scene::Body& body,
                                                      const scene::Material& material, double highest);

}  // namespace idiophone::accuracy
