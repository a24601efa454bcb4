#include "idiophone/solids/accuracy/pitch_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "twist_error.hpp"

namespace idiophone::accuracy {

namespace {

/// Side of the cells that the largest element was made of, m: a square's diagonal is its longest edge.
double size_of(const mesh::Statistics& mesh) {
  return mesh.largest_edge / std::sqrt(2.0);
}

double thickness_of(const mesh::Statistics& mesh) {
  return extents(mesh).thickness;
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
  if (const auto along = scene::constants_along_axes(material)) {
    return {along->young.minCoeff(), along->shear.minCoeff()};
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

Extents extents(const mesh::Statistics& mesh) {
  // Half the surface over the volume of a box is the sum of the reciprocals of its sides.
  const double others = 1 / mesh.extents[0] + 1 / mesh.extents[1];
  const double reciprocal = mesh.surface_area / (2 * mesh.volume) - others;
  return {mesh.extents, 1 / std::max(reciprocal, 1 / mesh.extents[2])};
}

std::optional<std::string> without_rules(const scene::Body& body, const mesh::Statistics& mesh) {
  if (!body.regions.empty()) {
    return "bodies of several materials";
  }
  if (body.prestress) {
    return "bodies under tension";
  }
  if (const Extents size = extents(mesh); size.sides[2] > 2 * size.thickness) {
    return "curved or joined thin walls";
  }
  return {};
}

Cells cells_of(const mesh::Statistics& mesh, element::Type type) {
  return {.type = type,
          .size = element::lines_through(type) > 0 ? mesh.largest_edge : size_of(mesh),
          .across = mesh.cells[1],
          .layer = std::min(mesh.cells[2], thickness_of(mesh))};
}

namespace {

double tetrahedra_error(const Cells& cells, double thickness, double wavelength) {
  const double slenderness = cells.size / thickness;
  const double locking = slenderness * slenderness / (slenderness * slenderness + 16);
  return (2000 + 4500 * locking) * std::pow(std::max(cells.size, cells.layer) / wavelength, 2);
}

/// Cents of hexahedra of an order, waves running along cells of a size (m).
double dispersion(int order, double size, double wavelength) {
  // With two cells to a wavelength: docs/pictures/error_over_cost.png, tools/error_over_cost.
  constexpr std::array<double, element::highest_hex_order + 1> with_two = {0, 0, 800, 110, 0.5, 0.5, 0.05, 0.05, 0.05};
  const double share = 2 * size / wavelength;
  return share > 1 ? std::numeric_limits<double>::infinity() : with_two[order] * std::pow(share, 2 * order - 2);
}

double hexahedra_error(const Cells& cells, double wavelength) {
  const double through = cells.type.thickness == 2 ? 1200 * std::pow(cells.layer / wavelength, 2)
                                                   : dispersion(cells.type.thickness, cells.layer, wavelength);
  return dispersion(cells.type.plane, cells.size, wavelength) + through;
}

/// Cents of waves in the plane.
double dispersion_error(const Cells& cells, double thickness, double wavelength) {
  switch (cells.type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return tetrahedra_error(cells, thickness, wavelength);
    case element::Kind::hex:
      return hexahedra_error(cells, wavelength);
  }
  element::unknown_kind();
}

/// The lowest frequency, Hz, of torsion about the longest axis: a quarter of a wave, as of a bar that is clamped at one
/// end. Torsional stiffness of a rectangle (Young, Budynas, Sadegh, Roark's Formulas, table 10.7) over the polar
/// moment.
double lowest_torsion(const Extents& body, const scene::Material& material) {
  const double slenderness = body.sides[2] / body.sides[1];
  const double constant =
      4 * slenderness * slenderness * (1 - 0.63 * slenderness * (1 - std::pow(slenderness, 4) / 12));
  const double speed =
      std::sqrt(softest(material).shear / material.density * constant / (1 + slenderness * slenderness));
  return speed / (4 * body.sides[0]);
}

}  // namespace

double pitch_error(const Cells& cells, const Extents& body, const scene::Material& material, double frequency) {
  const double wavelength = bending_wavelength(material, body.thickness, frequency);
  const double waves = dispersion_error(cells, body.thickness, wavelength);
  return frequency < lowest_torsion(body, material) ? waves : std::max(waves, twist_error(cells, body));
}

double highest_frequency(const Cells& cells, const Extents& body, const scene::Material& material, double cents) {
  return crossing([&](double frequency) { return pitch_error(cells, body, material, frequency) < cents; });
}

namespace {

/// Elements that lock in bending.
std::optional<std::string> locking_warning(const mesh::Statistics& mesh, const scene::Body& body) {
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
std::optional<std::string> wavelength_warning(const mesh::Statistics& mesh, const scene::Body& body,
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
      "Use elements of {:.2g} m, not {:.2g} m, or set audio.max_frequency (docs/use/mesh_guide.md)",
      body.name, limit, highest, cells(highest), cells_for_a_wave, size * cells(highest) / cells_for_a_wave, size);
}

}  // namespace

std::optional<std::string> mesh_warning(const mesh::Statistics& mesh, const scene::Body& body,
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

}  // namespace idiophone::accuracy
