#pragma once
// What the modes left out do where a force acts: they follow it like a spring. Each node has an oscillator of its own
// with that flexibility, above the audible range but not as fast as the finite elements, so that it limits the step of
// a contact less than their mass does.

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "modal_oscillators.hpp"
#include "modal_shapes.hpp"

namespace idiophone::modal_bodies {

using motion::Step;

class ResidualFlexibility {
 public:
  ResidualFlexibility() = default;
  /// @param mobility  [nodes] how much mass a node would need to follow a force faster than any mode kept, 1/kg: a
  ///                  bound of the oscillators' inverse mass
  ResidualFlexibility(const ModalBasis& basis, std::span<const double> mobility);

  /// Whether there is any.
  [[nodiscard]] bool exists() const { return !flexibility_.empty(); }

  /// From now on, these nodes move, ascending, in packs in this order. All others come to rest.
  /// @param step  length of the steps from now on, s
  void choose(std::span<const std::size_t> nodes, double step);

  /// Takes a pack of the chosen nodes one step further.
  /// @param force  N
  void advance(std::size_t pack, const PackVector& force, const Step& step);

  /// Adds displacement and velocity of a pack of the chosen nodes, m and m/s.
  void add(std::size_t pack, NodeGroup::Vibration& vibration) const;

  /// What a force at a node accelerates it at once by, 1/kg.
  [[nodiscard]] double inverse_mass(std::size_t node) const;

  [[nodiscard]] double kinetic_energy() const;  ///< J
  [[nodiscard]] double elastic_energy() const;  ///< J

  /// Of a node, which must be chosen if it is to be restored.
  void archive(std::size_t node, parallel::ArchiveRow& row);

 private:
  /// As many of the chosen nodes as a pack has lanes.
  struct NodePack {
    Pack flexibility = {};  ///< m/N
    Pack frequency = {};    ///< rad/s
    Pack keep = {};         ///< as OscillatorStep
    Pack pull = {};         ///< likewise
    PackVector place = {};  ///< m
    PackVector rate = {};   ///< m/s
  };
  static constexpr std::size_t none = -1;

  /// Of a pack of chosen nodes over a step that is longer or shorter than the one before.
  static void change_length(NodePack& nodes, const PackVector& force, const Step& step);

  /// Sum over the chosen nodes of the square of a vector over an inverse stiffness or mass, which is not zero.
  template <class Vector, class Inverse>
  [[nodiscard]] double sum_of_squares(Vector vector, Inverse inverse) const;

  std::vector<double> flexibility_;  ///< [nodes] m/N
  std::vector<double> frequency_;    ///< [nodes] rad/s; zero where there is no flexibility
  double length_ = 0.0;              ///< of the steps, s
  std::vector<std::size_t> chosen_;  ///< nodes, ascending
  std::vector<std::size_t> slot_;    ///< [nodes] place among the chosen, or none
  std::vector<NodePack> packs_;
};

}  // namespace idiophone::modal_bodies
