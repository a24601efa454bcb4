#include "harmonic_kirchhoff.hpp"

#include <numbers>
#include <numeric>

#include "far_image.hpp"
#include "idiophone/air/surface/equivalent_radius.hpp"
#include "panel.hpp"

namespace idiophone::harmonic {

namespace {

/// A triangle as a monopole and a dipole along its normal at its centre.
struct HarmonicSource {
  Vector3 centre = Vector3::Zero();
  Vector3 normal = Vector3::Zero();
  Complex monopole;
  Complex dipole;
};

std::vector<HarmonicSource> harmonic_sources(const Boundary& boundary, Index first, Index last, const QuietAir& air,
                                             double wave_number, std::span<const Complex> normal_velocity) {
  std::vector<std::array<Vector3, 3>> corners;
  for (Index t = first; t < last; ++t) {
    const auto& [a, b, c] = boundary.triangles[t];
    corners.push_back({boundary.vertices[a], boundary.vertices[b], boundary.vertices[c]});
  }
  std::vector<Index> all(corners.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<double> radii = surface::equivalent_radii(corners, all);
  std::vector<HarmonicSource> sources;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const Panel panel(corners[t]);
    const Complex* velocity = &normal_velocity[3 * (first + t)];
    const Complex wave = air.impedance() * (velocity[0] + velocity[1] + velocity[2]) / 3.0;  // of a plane wave, Pa
    const Complex s(0.0, wave_number * radii[t]);
    const double share = panel.area / (4.0 * std::numbers::pi);
    sources.push_back({panel.centre, panel.normal, share * Complex(0.0, wave_number) * wave,
                       share * wave * (s * s + s) / (s * s + 2.0 * s + 2.0)});
  }
  return sources;
}

}  // namespace

ModelledFarField modelled_far_field(const Boundary& boundary, Index first, Index last, const QuietAir& air,
                                    double wave_number, std::span<const Complex> normal_velocity,
                                    std::span<const Vector3> directions) {
  const auto sources = harmonic_sources(boundary, first, last, air, wave_number, normal_velocity);
  const auto sum_of = [&](const Vector3& direction, const auto& strength) {
    Complex sum = 0.0;
    for (const HarmonicSource& source : sources) {
      sum +=
          std::polar(1.0, wave_number * direction.dot(source.centre)) * strength(source, direction.dot(source.normal));
    }
    return sum;
  };
  const auto kirchhoff = [&](const Vector3& direction) {
    return sum_of(direction, [&](const HarmonicSource& source, double cosine) {
      return source.monopole + Complex(0.0, wave_number * cosine) * source.dipole;
    });
  };
  const auto rayleigh = [&](const Vector3& direction) {
    return sum_of(direction, [&](const HarmonicSource& source, double cosine) {
      return cosine > 0 ? 2.0 * source.monopole : Complex(0.0);
    });
  };
  ModelledFarField field;
  for (const Vector3& wanted : directions) {
    field.kirchhoff.push_back(with_image(boundary.floor, wave_number, wanted, kirchhoff));
    field.rayleigh.push_back(with_image(boundary.floor, wave_number, wanted, rayleigh));
  }
  return field;
}

}  // namespace idiophone::harmonic
