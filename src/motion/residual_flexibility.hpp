#pragma once
// What the modes left out do where a force acts: they follow it like a spring. Each node has an oscillator of its own
// with that flexibility, above the audible range but not as fast as the finite elements, so that it limits the step of
// a contact less than their mass does.

#include <vector>

#include "idiophone/parallel/archive_row.hpp"
#include "modal_shapes.hpp"
#include "oscillators.hpp"

namespace idiophone::motion {

class ResidualFlexibility {
 public:
  ResidualFlexibility() = default;
  /// @param mobility  [nodes] how much mass a node would need to follow a force faster than any mode kept, 1/kg: a
  /// bound
  ///                  of the oscillators' inverse mass
  ResidualFlexibility(const ModalBasis& basis, std::span<const double> mobility);

  void begin(double step);

  /// Whether there is any.
  [[nodiscard]] bool exists() const { return !flexibility_.empty(); }

  /// Takes eight nodes one step further.
  /// @param force  N
  void advance(std::size_t pack, const PackVector& force, double step);

  /// Brings to rest all nodes but those of these packs, ascending.
  void rest_but(std::span<const std::size_t> packs);

  /// Adds displacement and velocity, m and m/s.
  void add(std::size_t pack, ModalShapes::Vibration& vibration) const;

  /// What a force at a node accelerates it at once by, 1/kg.
  [[nodiscard]] double inverse_mass(std::size_t node) const;

  [[nodiscard]] double kinetic_energy() const;  ///< J
  [[nodiscard]] double elastic_energy() const;  ///< J

  void archive(std::size_t node, parallel::ArchiveRow& row);

 private:
  std::vector<Pack> flexibility_;  ///< [packs] m/N
  std::vector<Pack> frequency_;    ///< [packs] rad/s; zero where there is no flexibility
  std::vector<Pack> keep_;         ///< [packs] as OscillatorStep
  std::vector<Pack> pull_;         ///< likewise
  std::vector<PackVector> place_;  ///< [packs] m
  std::vector<PackVector> rate_;   ///< [packs] m/s
};

}  // namespace idiophone::motion
