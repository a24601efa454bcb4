#include "idiophone/mesh/pitch_error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace idiophone::mesh {

namespace {

/// Side of the cells that the largest element was made of, m: a square's diagonal is its longest edge.
double size_of(const Statistics& mesh) {
  return mesh.largest_edge / std::sqrt(2.0);
}

/// Of a plate or shell, m; two thirds of a ball's radius.
double thickness_of(const Statistics& mesh) {
  return 2 * mesh.volume / mesh.surface_area;
}

/// The frequency, Hz, up to which a condition holds.
template <class Condition>
double crossing(Condition&& holds) {
  double low = 1e-3;
  double high = 1e9;
  while (high / low > 1.0001) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// Stiffness against bending of a wide plate and against shear, Pa. Of wood the smallest: waves across the grain are
/// the shortest.
struct Softest {
  double plate;
  double shear;
};

Softest softest(const scene::Material& material) {
  if (material.orthotropy) {
    return {material.orthotropy->young.minCoeff(), material.orthotropy->shear.minCoeff()};
  }
  const double poisson = material.poisson;
  return {material.young / (1 - poisson * poisson), material.young / (2 * (1 + poisson))};
}

}  // namespace

double bending_wavelength(const scene::Material& material, double thickness, double frequency) {
  const double omega = 2 * std::numbers::pi * frequency;
  const double bending_speed = std::sqrt(omega * thickness * plate_speed(material) / std::sqrt(12.0));
  const double rayleigh_speed = 0.93 * std::sqrt(softest(material).shear / material.density);
  const double speed = std::cbrt(1 / (std::pow(bending_speed, -3) + std::pow(rayleigh_speed, -3)));
  return speed / frequency;
}

double plate_speed(const scene::Material& material) {
  return std::sqrt(softest(material).plate / material.density);
}

double pitch_error(const Statistics& mesh, const scene::Material& material, double frequency) {
  const double slenderness = size_of(mesh) / thickness_of(mesh);
  const double locking = slenderness * slenderness / (slenderness * slenderness + 16);
  const double waves = size_of(mesh) / bending_wavelength(material, thickness_of(mesh), frequency);
  return (2000 + 4500 * locking) * waves * waves;
}

double highest_frequency(const Statistics& mesh, const scene::Material& material, double cents) {
  return crossing([&](double frequency) { return pitch_error(mesh, material, frequency) < cents; });
}

namespace {

/// Elements that lock in bending.
std::optional<std::string> locking_warning(const Statistics& mesh, const scene::Body& body) {
  constexpr double cells_for_tet4 = 8;  // across the thickness: still some 5 % sharp
  const double size = size_of(mesh);
  const double thickness = thickness_of(mesh);
  if (thickness / size > cells_for_tet4) {
    return std::nullopt;
  }
  return fmt::format(
      "body {}: tet4 elements of {:.3g} m lock in a part {:.3g} m thick and sound far too high; use element: tet10",
      body.name, size, thickness);
}

/// Elements too long for the waves that are to be heard.
std::optional<std::string> wavelength_warning(const Statistics& mesh, const scene::Body& body,
                                              const scene::Material& material, double highest) {
  constexpr double cells_for_a_wave = 4;  // with fewer, even the order of the partials is chance
  const double size = size_of(mesh);
  const double thickness = thickness_of(mesh);
  const auto cells = [&](double frequency) { return bending_wavelength(material, thickness, frequency) / size; };
  if (cells(highest) >= cells_for_a_wave) {
    return std::nullopt;
  }
  const double limit = crossing([&](double frequency) { return cells(frequency) > cells_for_a_wave; });
  return fmt::format(
      "body {}: too coarse above {:.0f} Hz: at {:.0f} Hz bending waves are {:.1f} elements long, not {:.0f} or more. "
      "Use elements of {:.2g} m, not {:.2g} m, or set audio.max_frequency (docs/mesh_guide.md)",
      body.name, limit, highest, cells(highest), cells_for_a_wave, size * cells(highest) / cells_for_a_wave, size);
}

}  // namespace

std::optional<std::string> mesh_warning(const Statistics& mesh, const scene::Body& body,
                                        const scene::Material& material, double highest) {
  switch (body.element.kind) {
    case element::Kind::tet4:
      return locking_warning(mesh, body);
    case element::Kind::tet10:
      return wavelength_warning(mesh, body, material, highest);
    case element::Kind::hex:
      return std::nullopt;
  }
  element::unknown_kind();
}

}  // namespace idiophone::mesh
