#pragma once
// What a mesh does to the pitch of its body: rules of docs/mesh_guide.md, whose numbers come from
// verification/report.md.

#include <optional>
#include <string>

#include "idiophone/mesh/statistics.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::mesh {

/// Length of a bending wave, m, in a plate of a thickness (m) at a frequency (Hz). Its speed follows Kirchhoff's plate
/// while it is slow and approaches that of Rayleigh waves: c^-3 = (w^2 D/(rho h))^(-3/4) + c_R^-3, c_R = 0.93 c_shear.
[[nodiscard]] double bending_wavelength(const scene::Material& material, double thickness, double frequency);

/// Speed of waves of stretching in a thin plate, m/s; of an orthotropic material the smallest.
[[nodiscard]] double plate_speed(const scene::Material& material);

/// Cents by which the partials of a tet10 mesh near a frequency (Hz) may be wrong, within a factor of two and clamped
/// edges left aside: C (size/wavelength)^2. C is 2000 where elements are no longer than the part is thick, and grows to
/// 6500 where they are many times longer.
[[nodiscard]] double pitch_error(const Statistics& mesh, const scene::Material& material, double frequency);

/// The highest frequency, Hz, up to which `pitch_error` stays below some cents.
[[nodiscard]] double highest_frequency(const Statistics& mesh, const scene::Material& material, double cents);

/// What is wrong with a body's mesh, or nothing: elements that lock, or too long for the highest frequency (Hz) that is
/// to be heard.
[[nodiscard]] std::optional<std::string> mesh_warning(const Statistics& mesh, const scene::Body& body,
                                                      const scene::Material& material, double highest);

}  // namespace idiophone::mesh
