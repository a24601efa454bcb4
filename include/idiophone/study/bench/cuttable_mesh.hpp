#pragma once
// The mesh of a body whose nodes move with cuts at one of its sides.

#include <array>
#include <memory>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/study/bench/cut_model.hpp"
#include "idiophone/study/bench/cut_side.hpp"

namespace idiophone::bench {

class SidePieces;
class TrianglesAlong;

/// Nodes of the side move into the body by the mean depth of the cuts around them, weighted by the shape functions of
/// the surface (SidePieces), so that the removed volume is right however narrow a cut is, and wherever. Nodes
/// between the side and the surface behind it move with them, the less the nearer they are to that surface.
class CuttableMesh {
 public:
  /// @throws as side_faces()
  CuttableMesh(mesh::Mesh mesh, const Side& side);
  ~CuttableMesh();
  CuttableMesh(const CuttableMesh&) = delete;
  CuttableMesh& operator=(const CuttableMesh&) = delete;

  [[nodiscard]] const mesh::Mesh& uncut() const { return mesh_; }

  /// The least thickness of the body between the side and the surface behind it, m.
  [[nodiscard]] double thinnest() const;

  /// The mesh after some cuts. Its hash is empty: it is another body.
  /// @throws OutsideOfModel where cuts take more than half of the thickness
  [[nodiscard]] mesh::Mesh with(const std::vector<Cut>& cuts) const;

 private:
  /// A node that moves by the mean depth at the corners of the face below it.
  struct Follower {
    Index node;
    mesh::Triangle corners;
    std::array<double, 3> shares;  ///< of the depth at each corner
    double thickness;              ///< of the body at this node, m
  };

  void follow(Index node, const TrianglesAlong& faces, const TrianglesAlong& surface);

  mesh::Mesh mesh_;
  Side side_;
  std::unique_ptr<const SidePieces> pieces_;  ///< of the side
  std::vector<Follower> followers_;
};

}  // namespace idiophone::bench
