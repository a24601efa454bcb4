#pragma once
// The eigenproblem of bodies on their meshes and on refined meshes, and the way between them. On one rank.

#include <petscksp.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/mesh/refined.hpp"
#include "operators.hpp"

namespace idiophone::eigenmodes {

/// Operators of a body, or of bodies that joints tie together, on some meshes, with all that they refer to.
struct MeshedBodies {
  /// @throws deck::DeckError as motion::attach()
  MeshedBodies(const scene::Solids& all, const std::vector<mesh::Mesh>& meshes, MassMatrix mass);
  /// On refined meshes, whose joints hold the same parts of the bodies, and have the stiffness and the reach of the
  /// given ones: those that the deck leaves open depend on the width of the faces.
  /// @throws deck::DeckError as motion::attach() and joints::refined()
  MeshedBodies(const MeshedBodies& given, const std::vector<mesh::Mesh>& meshes,
               const std::vector<mesh::RefinedMesh>& refined, MassMatrix mass);
  MeshedBodies(const MeshedBodies&) = delete;
  MeshedBodies& operator=(const MeshedBodies&) = delete;
  MeshedBodies(MeshedBodies&&) = delete;
  MeshedBodies& operator=(MeshedBodies&&) = delete;
  ~MeshedBodies() = default;

  scene::Assembly assembly;  ///< with the elements of the meshes
  scene::Solids solids;
  mesh::Part part;
  motion::Attachments attachments;
  Operators operators;

 private:
  MeshedBodies(const MeshedBodies& given, const std::vector<mesh::Mesh>& meshes,
               const std::vector<mesh::RefinedMesh>& refined, const std::vector<mesh::Mesh>& of_refined,
               MassMatrix mass);
};

class RefinedProblem {
 public:
  /// @param solids  of one body, or of bodies that joints tie together, and none of these is a bolt without a shank
  /// @param meshes  of the bodies, all of elements of one kind
  /// @param lowest  shape of the lowest mode, [3 x nodes of all bodies]
  /// @throws deck::DeckError as motion::attach() and joints::refined(), std::runtime_error where PETSc can't
  RefinedProblem(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes, MassMatrix mass,
                 std::span<const double> lowest);

  [[nodiscard]] PetscInt size() const { return refined_.operators.size(); }  ///< free components
  [[nodiscard]] Mat stiffness() const { return refined_.operators.stiffness(); }
  [[nodiscard]] Mat mass() const { return refined_.operators.mass(); }

  /// x^T K x/x^T M x on the given mesh, (rad/s)^2.
  /// @param shape  [3 x nodes]
  [[nodiscard]] double given_value(std::span<const double> shape) const;
  /// Of the refined mesh: [free components x motions]
  [[nodiscard]] Eigen::MatrixXd rigid_motions() const;
  /// The same motion of the refined mesh, among its free components.
  /// @param shape  [3 x nodes]
  void interpolate(std::span<const double> shape, Vec interpolated) const;
  /// About K^-1 times a vector of forces: a cycle of two grids, Gauss and Seidel's sweeps on the refined mesh before
  /// and after a solution on the given one. Symmetric.
  void precondition(Vec force, Vec displacement) const;

 private:
  RefinedProblem(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                 const std::vector<mesh::RefinedMesh>& refined, MassMatrix mass, std::span<const double> lowest);
  void connect(const std::vector<mesh::RefinedMesh>& refined);
  void set_up_cycle(double shift);

  MeshedBodies given_;
  MeshedBodies refined_;
  parallel::Handle<Mat> interpolation_;  ///< [free components of the refined mesh x of the given one]
  parallel::Handle<Mat> coarse_;         ///< K + shift M of the given mesh
  parallel::Handle<PC> cycle_;
};

}  // namespace idiophone::eigenmodes
