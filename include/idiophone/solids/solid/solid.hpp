#pragma once
// One deformable body on this rank, whatever its element type and materials.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/scene/material.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "idiophone/solids/solid/memory.hpp"
#include "idiophone/solids/solid/oriented_material.hpp"
#include "idiophone/solids/solid/pack_division.hpp"
#include "idiophone/solids/solid/packed_elements.hpp"

namespace idiophone::solid {

/// A body whose material has a loss factor is, until begin_memory, as soft as it is after an eternity at rest.
class Solid {
 public:
  /// @param reference  [local nodes] positions X, m
  /// @param materials  [regions]
  /// @throws std::runtime_error naming an element whose Jacobian is not positive; deck::DeckError where the loss
  /// factor can't be kept (relaxation.hpp)
  Solid(const mesh::BodyPart& part, std::span<const Vector3> reference, std::span<const OrientedMaterial> materials);

  /// A body of one material.
  /// @param axes  of a material that is not isotropic, in the columns
  Solid(const mesh::BodyPart& part, std::span<const Vector3> reference, const scene::Material& material,
        const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity())
      : Solid(part, reference, std::array{OrientedMaterial{material, axes}}) {}

  /// From now on, begin_internal_force needs no ghosts.
  /// @param part  that of the constructor
  void divide(const mesh::BodyPart& part) { division_ = PackDivision::by_ghosts(part); }

  /// From now on, forces depend on the history of strain in steps of dt = `step` (s), where there is a loss factor.
  void begin_memory(double step);

  /// Adds elastic and damping forces, N. state, force: [local nodes], velocities of the middle of the step before
  void add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const;

  /// The same, once a step: the memory goes on to the present.
  void add_internal_force_and_remember(std::span<const NodeState> state, std::span<NodeForce> force) {
    begin_internal_force(state, force);
    finish_internal_force(state, force);
  }

  /// The first part of this: after divide(), the elements whose packs need no ghost; otherwise all.
  void begin_internal_force(std::span<const NodeState> state, std::span<NodeForce> force);

  /// The second part, with the same arguments. The ghosts have their states.
  void finish_internal_force(std::span<const NodeState> state, std::span<NodeForce> force);

  /// Adds the lumped mass. [local nodes], kg; complete only at owned nodes
  void add_mass(std::span<double> mass) const;

  /// Elastic energy of each element computed here, J, [elements]
  void elastic_energy(std::span<const NodeState> state, std::span<double> energy) const;

  /// Force of the body at rest under the linear stiffness K against a blow: adds -K x to `force`, x given as the
  /// velocities in `state` (whose displacements must be zero). At rest Kelvin-Voigt's damping force is -beta K v, and
  /// beta is set to 1 s. K is that of the material: a prestress adds nothing to it.
  void add_linear_stiffness_force(std::span<const NodeState> state, std::span<NodeForce> force) const;
  /// That of one region's elements, if this is their elasticity.
  void add_linear_stiffness_force(std::size_t region, const Elasticity& elasticity, std::span<const NodeState> state,
                                  std::span<NodeForce> force) const;

  /// Damping of motion so fast that K is the stiffness: 2 zeta w = stiffness-proportional w^2 + what the loss factor
  /// adds, 1/s. Of several materials, that of the one that damps most.
  /// @param frequency  w, rad/s
  [[nodiscard]] double damping(double frequency) const;

  [[nodiscard]] Index element_count() const { return layout().element_count(); }
  [[nodiscard]] std::size_t region_count() const { return regions_.size(); }

  /// What the loss factor makes of the elastic moduli at each frequency; 1 at all of them where there is none.
  [[nodiscard]] const Relaxation& relaxation(std::size_t region = 0) const { return regions_[region].relaxation; }

  /// Damping proportional to stiffness, s.
  [[nodiscard]] double stiffness_damping(std::size_t region = 0) const { return regions_[region].beta; }

  /// The deck's elasticity: with a loss factor, that in the middle of its band.
  [[nodiscard]] const Elasticity& elasticity(std::size_t region = 0) const { return regions_[region].elasticity; }

  /// The part of it that the relaxation acts on: all of it, but for a loss factor by direction (directional_loss.hpp).
  [[nodiscard]] const Elasticity& relaxing_elasticity(std::size_t region = 0) const {
    return regions_[region].relaxing;
  }

  /// Whether this is a part of the elasticity only, because the loss factor depends on the direction.
  [[nodiscard]] bool has_directional_loss(std::size_t region = 0) const {
    return regions_[region].relaxing_strain.has_value();
  }

  /// Elasticity after an eternity at rest: that of static equilibria.
  [[nodiscard]] const Elasticity& relaxed_elasticity(std::size_t region = 0) const { return regions_[region].relaxed; }

  /// Stress of the body where it rests, Pa.
  [[nodiscard]] const Eigen::Matrix3d& initial_stress(std::size_t region = 0) const { return regions_[region].stress; }

  /// Whether any region is stressed where the body rests.
  [[nodiscard]] bool is_prestressed() const;

  /// A bound for what the geometric stiffness of the prestress adds to the largest eigenvalue of K, as a share of it;
  /// for a diagonal mass. With s the largest principal stress and c the least stiffness of any strain, u.s.u of the
  /// gradients of one component of the displacement is at most 2 s/c times the energy of its strain.
  [[nodiscard]] double geometric_share() const;

  /// kg/m3
  [[nodiscard]] double density(std::size_t region = 0) const { return regions_[region].density; }

  /// Memory of its tables.
  [[nodiscard]] std::size_t bytes() const;

  /// Whether forces depend on the history of strain.
  [[nodiscard]] bool has_memory() const;

  /// What an element computed here remembers, the same on any partition, as many numbers for every element. The solid
  /// has a memory.
  void archive_memory(std::size_t element, parallel::ArchiveRow& row);

 private:
  /// The elements of one material.
  struct Region {
    Region(const OrientedMaterial& oriented, PackRange its_packs);

    /// As Solid::damping().
    [[nodiscard]] double most_damping(double frequency) const;

    PackRange packs;
    double beta;  ///< damping proportional to stiffness, s
    double density;
    Relaxation relaxation;
    Elasticity elasticity;     ///< the deck's
    Elasticity relaxing;       ///< the part of it that the relaxation acts on
    Elasticity relaxed;        ///< at frequency 0, without creep
    Elasticity instantaneous;  ///< against a blow
    Eigen::Matrix3d stress;    ///< where the body rests, Pa
    /// Strains that make this stress with `elasticity` and with `relaxed`. None: no stress.
    std::optional<std::array<PackSymmetric, 2>> initial_strains;
    /// Of a loss factor by direction; see directional_loss.hpp.
    std::optional<AnisotropicElasticity> relaxing_strain = std::nullopt;
    std::optional<double> largest_relaxing_share = std::nullopt;
    std::optional<Memory> memory = std::nullopt;
  };

  [[nodiscard]] const PackLayout& layout() const;
  [[nodiscard]] std::size_t points() const;

  /// Adds the forces of some packs; the memory goes on to the present.
  void add_and_remember(std::span<const PackRange> ranges, std::span<const NodeState> state,
                        std::span<NodeForce> force);

  PackedElements elements_;
  std::vector<Region> regions_;
  PackDivision division_;
};

}  // namespace idiophone::solid
