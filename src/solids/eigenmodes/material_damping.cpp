#include "idiophone/solids/eigenmodes/material_damping.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "idiophone/solids/solid/material_relaxation.hpp"

namespace idiophone::eigenmodes {

DampedVibration damped(double square, double of_others, std::span<const MaterialStrain> materials) {
  const auto modulus = [&](const MaterialStrain& material) { return material.relaxation.modulus(std::sqrt(square)); };
  double stiffened = square;
  for (const MaterialStrain& material : materials) {
    stiffened += (modulus(material).real() - 1) * material.relaxing;
  }
  DampedVibration vibration{.angular_frequency = std::sqrt(stiffened), .damping = of_others};
  for (const MaterialStrain& material : materials) {
    vibration.damping += material.stiffness_damping * material.share +
                         modulus(material).imag() / vibration.angular_frequency * material.relaxing;
  }
  return vibration;
}

std::vector<DampedVibration> damped_by(const scene::Damping& damping, std::span<const double> lossless_frequencies) {
  if (damping.has_directional_loss()) {
    throw deck::DeckError(damping.loss->where,
                          "a loss factor by direction damps each mode by how it strains the body, which is not stored: "
                          "compute the modes again");
  }
  std::array material = {
      MaterialStrain{.stiffness_damping = damping.stiffness, .relaxation = solid::relaxation_of(damping)}};
  std::vector<DampedVibration> vibrations;
  for (const double frequency : lossless_frequencies) {
    const double square = std::pow(2 * std::numbers::pi * frequency, 2);
    material.front().share = material.front().relaxing = square;
    vibrations.push_back(damped(square, damping.of_all_motion(), material));
  }
  return vibrations;
}

}  // namespace idiophone::eigenmodes
