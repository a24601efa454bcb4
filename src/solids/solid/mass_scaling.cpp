#include "idiophone/solids/solid/mass_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "idiophone/solids/accuracy/pitch_error.hpp"

namespace idiophone::solid {

namespace {

constexpr double most = 30.0;  // more gains nothing: the nodes' distance in the plane rules the step then
constexpr double edge_factor = 1.3;
constexpr double cents_per_octave = 1200.0;

/// Shares of a wave's kinetic energy that each kind of relative motion has.
struct EnergyShares {
  double stretch;    ///< in waves of stretching
  double plane_bow;  ///< likewise
  double bow;        ///< in waves of bending
  double rotation;   ///< likewise
};

EnergyShares shares(const scene::Material& material, double thickness, double frequency) {
  const auto along = scene::constants_along_axes(material);
  const double poisson = along ? std::min(0.5, along->poisson.cwiseAbs().maxCoeff()) : material.poisson;
  const double squeeze = std::pow(poisson / (1 - poisson), 2);
  const double omega = 2 * std::numbers::pi * frequency;
  const double stretching = std::pow(omega / accuracy::plate_speed(material) * thickness, 2);  // (k h)^2
  const double bending =
      std::pow(2 * std::numbers::pi / accuracy::bending_wavelength(material, thickness, frequency) * thickness, 2);
  return {.stretch = squeeze * stretching / 12,
          .plane_bow = squeeze * stretching * stretching / 720,
          .bow = squeeze * bending * bending / 720,
          .rotation = edge_factor * bending / 12};
}

}  // namespace

double predicted_shift(const MassScaling& scaling, const scene::Material& material, double thickness,
                       double frequency) {
  const EnergyShares share = shares(material, thickness, frequency);
  // Kinetic energy that grows by a share lowers the frequency by half of it.
  const double stretching = scaling.stretch * share.stretch + scaling.plane_bow * share.plane_bow;
  const double bending = scaling.bow * share.bow + scaling.rotation * share.rotation;
  return cents_per_octave / 2 * std::log2(1 + std::max(stretching, bending));
}

MassScaling choose_scaling(const scene::Material& material, double thickness, double frequency, double shift) {
  const EnergyShares share = shares(material, thickness, frequency);
  const double each = (std::exp2(2 * shift / cents_per_octave) - 1) / 2;  // two kinds share each sort of waves
  const auto factor = [&](double of_energy) { return std::min(most, each / of_energy); };
  return {.stretch = factor(share.stretch),
          .bow = factor(share.bow),
          .rotation = factor(share.rotation),
          .plane_bow = factor(share.plane_bow)};
}

}  // namespace idiophone::solid
