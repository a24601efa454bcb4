#pragma once
// What must be known of the whole mesh before the first step: the same bits on any number of ranks. All ranks compute
// what takes much memory, each on its part; rank 0 adds up.

#include <mpi.h>

#include <vector>

#include "idiophone/solids/contact/contact_surfaces.hpp"
#include "idiophone/solids/motion/stable_step.hpp"

namespace idiophone::motion {

/// What mass scaling does to a body.
struct ScalingEffect {
  double gain = 1.0;   ///< the stable step over that without scaling
  double shift = 0.0;  ///< by how much the pitch of what can be heard falls at most, by an estimate, cents
};

/// What a body can fall apart into, undeformed.
struct Piece {
  std::size_t body;         ///< its number
  double mass;              ///< kg
  Vector3 centre;           ///< of mass, m
  Eigen::Matrix3d moments;  ///< second moments of mass, as InitialState has them of bodies, kg m2
};

struct InitialState {
  std::vector<StableStep> steps;         ///< [bodies]
  std::vector<ScalingEffect> scaling;    ///< [bodies]
  std::vector<double> masses;            ///< [bodies] kg
  std::vector<Vector3> centres;          ///< [bodies] centres of mass, m
  std::vector<Eigen::Matrix3d> moments;  ///< [bodies] second moments of mass, sum m (X - centre)(X - centre)^T, kg m2
  std::vector<Piece> pieces;             ///< of all bodies that can fall apart, as mesh::Part numbers them
  /// [bodies] Least mass of a surface node over the area that it has of its triangles, kg/m2. It limits the step under
  /// a force that grows with the velocity of the surface.
  std::vector<double> surface_densities;
  std::vector<double> displacement;  ///< [3 x global nodes] static preload, m; empty for none

  /// The smallest of the bodies' stable steps, s; infinity where all of them are held everywhere.
  [[nodiscard]] double stable_step() const;
  /// The body that has it.
  [[nodiscard]] std::size_t limiting_body() const;
  /// The highest frequency at which a body's loss factor is to hold, Hz; 0 where none has one.
  [[nodiscard]] double highest_loss() const;
};

/// An initial state with the undeformed bodies' masses, centres, moments, pieces and surface densities alone.
/// @param dynamics  of the whole mesh, on this rank alone
/// @param whole     the whole mesh as one part
[[nodiscard]] InitialState mass_properties(const Dynamics& dynamics, const mesh::Part& whole);

/// The same on all ranks. Collective. See find_stable_steps and static_equilibrium for what it throws.
/// @param step              that the deck asks for, s; none where the program chooses it
/// @param meshes            on rank 0, of all bodies; ignored elsewhere. Where there are plucks, or a prestress
///                          deforms a body, rank 0 computes with all of them
/// @param part              of this rank
/// @param contact_surfaces  rank 0 chooses their stiffness here
/// @param models            of the bodies that do not consist of finite elements
[[nodiscard]] InitialState find_initial_state(const scene::Solids& solids, std::optional<double> step,
                                              const std::vector<mesh::Mesh>& meshes, const mesh::Part& part,
                                              const Attachments& attachments,
                                              contact::ContactSurfaces& contact_surfaces, const ModelMaker& models,
                                              MPI_Comm communicator);

}  // namespace idiophone::motion
