#pragma once
// The eigenproblem of a body on its mesh and on the refined mesh, and the way between them. On one rank.

#include <petscksp.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/refined.hpp"
#include "operators.hpp"

namespace idiophone::eigenmodes {

/// Operators of one body on one mesh, with all that they refer to.
struct MeshedBody {
  /// @throws deck::DeckError as motion::attach()
  MeshedBody(const scene::Solids& solids, mesh::Mesh mesh, MassMatrix mass);
  MeshedBody(const MeshedBody&) = delete;
  MeshedBody& operator=(const MeshedBody&) = delete;
  MeshedBody(MeshedBody&&) = delete;
  MeshedBody& operator=(MeshedBody&&) = delete;
  ~MeshedBody() = default;

  scene::Body body;  ///< with the element of the mesh
  scene::Solids solids;
  mesh::Part part;
  motion::Attachments attachments;
  Operators operators;
};

class RefinedProblem {
 public:
  /// @param solids  of one body
  /// @param mesh    of the body
  /// @param lowest  shape of the lowest mode, [3 x nodes]
  /// @throws deck::DeckError as motion::attach(), std::runtime_error where PETSc can't
  RefinedProblem(const scene::Solids& solids, const mesh::Mesh& mesh, MassMatrix mass, std::span<const double> lowest);

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
  RefinedProblem(const scene::Solids& solids, const mesh::Mesh& mesh, const mesh::RefinedMesh& refined, MassMatrix mass,
                 std::span<const double> lowest);
  void connect(const mesh::RefinedMesh& refined);
  void set_up_cycle(double shift);

  MeshedBody given_;
  MeshedBody refined_;
  parallel::Handle<Mat> interpolation_;  ///< [free components of the refined mesh x of the given one]
  parallel::Handle<Mat> coarse_;         ///< K + shift M of the given mesh
  parallel::Handle<PC> cycle_;
};

}  // namespace idiophone::eigenmodes
