#pragma once
// Mode shapes that can be compared across meshes.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::fitting {

struct ModeShapes {
  std::vector<double> frequencies;      ///< Hz, ascending
  std::vector<double> decay_times;      ///< T60, s; infinite where nothing damps a mode
  std::vector<Eigen::VectorXd> shapes;  ///< [modes][3 x nodes] displacement at the nodes
  std::vector<double> levels = {};      ///< [TuningOptions::levels] of the blows, dB; empty if none is wanted
  Eigen::Matrix3Xd places;              ///< [3 x nodes] of the nodes in the body's box, 0 to 1 along each side
  Vector3 sides = Vector3::Zero();      ///< of this box, m
};

/// Of modes that were found on a mesh.
[[nodiscard]] ModeShapes shapes_of(const mesh::Mesh& mesh, const std::vector<eigenmodes::Mode>& modes);

/// The lowest modes of a body, freshly meshed. On this rank alone.
/// @throws what mesh::read_mesh() and eigenmodes::find_modes() throw
[[nodiscard]] ModeShapes mode_shapes(const scene::Solids& solids, const eigenmodes::Options& options);

/// Estimated errors of the mesh of the lowest modes, cents, of all that are quick (eigenmodes::mesh_errors()). Meshes
/// and solves again. On this rank alone.
/// @return [modes] NaN without an estimate
/// @throws what mode_shapes() throws
[[nodiscard]] std::vector<double> mesh_errors_of(const scene::Solids& solids, const eigenmodes::Options& options);

/// The kind of each mode by mode_kinds::kinds_of(); empty where it has no name. [modes]
[[nodiscard]] std::vector<std::string> kinds_of(const ModeShapes& shapes);

/// Modal assurance criteria of all shapes of `others` with some of `known`, [chosen x others]: |a . b|^2/(a . a b . b)
/// over the nodes of `known`, where the other has the displacement of its nearest node (Allemang and Brown 1982). 1 for
/// the same shape.
[[nodiscard]] Eigen::MatrixXd similarities(const ModeShapes& known, const std::vector<int>& chosen,
                                           const ModeShapes& others);

}  // namespace idiophone::fitting
